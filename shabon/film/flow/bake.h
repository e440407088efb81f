// Values of the cells at many fixed directions: the weights are found once, each frame then takes a few operations a
// point. Linear over the triangles between the cells' centres.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shabon/film/flow/flow.h"
#include "shabon/math/vec.h"

namespace shabon::film {

class FlowBake {
 public:
  // Directions of any length but zero.
  FlowBake(const FilmFlow& flow, std::span<const math::Vec3d> directions);

  std::size_t size() const { return points_.size(); }
  // values: one a cell, as thickness_m() of the same or another flow of the same level; out: one a direction.
  void sample(std::span<const double> values, double scale, std::span<float> out) const;
  // The thickness in nm.
  void thickness_nm(const FilmFlow& flow, std::span<float> out) const { sample(flow.thickness_m(), 1e9, out); }

 private:
  struct Point {
    std::array<int, 3> cell;
    std::array<float, 3> weight;
  };
  std::vector<Point> points_;
};

// Where the middles of a latitude-longitude picture's pixels lie, row after row from the top, as in latitude_map.h; of
// a cube picture's: node_directions() in sphere_map.h.
std::vector<math::Vec3d> latitude_longitude_directions(int width, int height);

}  // namespace shabon::film
