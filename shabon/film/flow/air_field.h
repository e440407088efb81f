// The velocity of the air along the grid's edges, from what moves it.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/film/flow/air.h"
#include "shabon/film/flow/metric.h"

namespace shabon::film {

class AirField {
 public:
  AirField(const Metric& metric, std::vector<AirMotion> motions, std::uint64_t seed);

  // The sum of all at a time. Depends on the time alone, not on earlier calls.
  const Numbers& at(double time_s);

 private:
  // A field that keeps its shape: what it is multiplied with changes.
  struct Shape {
    std::size_t motion;
    std::int64_t part;
    Numbers along;
  };
  void add(const AirRotation& air, std::size_t motion, double time_s);
  void add(const AirJet& air, std::size_t motion, double time_s);
  void add(const AirGusts& air, std::size_t motion, double time_s);
  void add(const AirSwirls& air, std::size_t motion, double time_s);
  template <class Make>
  const Numbers& shape(std::size_t motion, std::int64_t part, const Make& make);
  void add_scaled(const Numbers& along, double factor);
  Numbers jet_shape(const math::Vec3d& place, const math::Vec3d& direction, double half_width_deg) const;
  Numbers swirl_shape(const AirSwirls& air, std::uint64_t seed) const;

  const Metric& metric_;
  std::vector<AirMotion> motions_;
  std::uint64_t seed_;
  std::vector<Shape> shapes_;
  Numbers sum_;
};

}  // namespace shabon::film
