#include "shabon/film/flow/air_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/film/flow/waves.h"
#include "shabon/math/normal_to.h"

namespace shabon::film {

using math::Vec3d;
using std::numbers::pi;

namespace {

double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// One puff of a train: where, where to, how strong, from when.
struct Puff {
  Vec3d place, direction;
  double strength, start_s;
};

Puff puff_of(const AirGusts& air, std::uint64_t seed, std::int64_t number) {
  Pcg32 random(hash64(seed, static_cast<std::uint64_t>(number)), 5);
  const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * pi), across = std::sqrt(1 - z * z);
  const Vec3d place{across * std::cos(turn), across * std::sin(turn), z};
  const Vec3d x = math::any_normal_to(place), y = math::cross(place, x);
  const double heading = random.uniform(0, 2 * pi);
  const double strength = air.speed_m_s * random.uniform(0.5, 1);
  const double start_s = (static_cast<double>(number) + random.uniform()) / air.rate_per_s;
  return {place, x * std::cos(heading) + y * std::sin(heading), strength, start_s};
}

}  // namespace

double share_at(const AirEnvelope& envelope, double time_s) {
  const double since = time_s - envelope.start_s, left = envelope.duration_s - since;
  if (since < 0 || left < 0) return 0;
  if (envelope.ramp_s <= 0) return 1;
  return smooth(since / envelope.ramp_s) * smooth(left / envelope.ramp_s);
}

AirField::AirField(const Metric& metric, std::vector<AirMotion> motions, std::uint64_t seed)
    : metric_(metric), motions_(std::move(motions)), seed_(seed), sum_(metric.grid->edge_numbers()) {}

template <class Make>
const Numbers& AirField::shape(std::size_t motion, std::int64_t part, const Make& make) {
  for (const Shape& known : shapes_)
    if (known.motion == motion && known.part == part) return known.along;
  shapes_.push_back({motion, part, make()});
  return shapes_.back().along;
}

void AirField::add_scaled(const Numbers& along, double factor) {
  double* sum = sum_.data();
  const double* field = along.data();
  const auto count = static_cast<Index>(sum_.size());
  for (Index e = 0; e < count; ++e) sum[e] += factor * field[e];
}

Numbers AirField::jet_shape(const Vec3d& place, const Vec3d& direction, double half_width_deg) const {
  const Vec3d centre = math::normalize(place), to = math::normalize(direction);
  const double per_width = 180 / (pi * half_width_deg);
  Numbers along = metric_.grid->edge_numbers();
  along_edges(
      *metric_.grid,
      [&](const Vec3d& at) {
        const double angle = std::acos(std::clamp(math::dot(at, centre), -1.0, 1.0)) * per_width;
        return to * std::exp(-angle * angle);
      },
      along);
  return along;
}

Numbers AirField::swirl_shape(const AirSwirls& air, std::uint64_t seed) const {
  const RandomWaves waves(seed, air.scale_m);
  Numbers stream = metric_.grid->triangle_numbers(), along = metric_.grid->edge_numbers();
  for (std::size_t t = 0; t < stream.size(); ++t) stream[t] = waves.stream(metric_.grid->corners[t] * metric_.radius);
  from_stream(metric_, stream, along);
  return along;
}

void AirField::add(const AirRotation& air, std::size_t motion, double time_s) {
  const double share = share_at(air.envelope, time_s) * air.speed_m_s;
  if (share == 0) return;
  add_scaled(shape(motion, 0,
                   [&] {
                     const Vec3d axis = math::normalize(air.axis);
                     Numbers along = metric_.grid->edge_numbers();
                     along_edges(
                         *metric_.grid, [&](const Vec3d& at) { return math::cross(axis, at); }, along);
                     return along;
                   }),
             share);
}

void AirField::add(const AirJet& air, std::size_t motion, double time_s) {
  const double share = share_at(air.envelope, time_s) * air.speed_m_s;
  if (share == 0) return;
  add_scaled(shape(motion, 0, [&] { return jet_shape(air.place, air.direction, air.half_width_deg); }), share);
}

void AirField::add(const AirGusts& air, std::size_t motion, double time_s) {
  const double share = share_at(air.envelope, time_s);
  if (share == 0 || air.rate_per_s == 0) return;
  const std::uint64_t seed = hash64(seed_, 100 + motion);
  const auto last = static_cast<std::int64_t>(std::floor(time_s * air.rate_per_s));
  const auto first = static_cast<std::int64_t>(std::floor((time_s - air.length_s) * air.rate_per_s)) - 1;
  std::erase_if(shapes_, [&](const Shape& known) { return known.motion == motion && known.part < first; });
  for (std::int64_t number = std::max<std::int64_t>(first, 0); number <= last; ++number) {
    const Puff puff = puff_of(air, seed, number);
    const double age = (time_s - puff.start_s) / air.length_s;
    if (age <= 0 || age >= 1) continue;
    const double rise = std::sin(pi * age);
    add_scaled(shape(motion, number, [&] { return jet_shape(puff.place, puff.direction, air.half_width_deg); }),
               share * puff.strength * rise * rise);
  }
}

void AirField::add(const AirSwirls& air, std::size_t motion, double time_s) {
  const double share = share_at(air.envelope, time_s) * air.speed_m_s;
  if (share == 0) return;
  const double turn = 2 * pi * time_s / air.change_s;
  for (const std::int64_t part : {0, 1})
    add_scaled(
        shape(motion, part,
              [&] { return swirl_shape(air, hash64(hash64(seed_, 200 + motion), static_cast<std::uint64_t>(part))); }),
        share * (part == 0 ? std::cos(turn) : std::sin(turn)));
}

const Numbers& AirField::at(double time_s) {
  sum_.fill(0);
  for (std::size_t n = 0; n < motions_.size(); ++n)
    std::visit([&](const auto& air) { add(air, n, time_s); }, motions_[n]);
  return sum_;
}

}  // namespace shabon::film
