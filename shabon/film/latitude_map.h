// Thickness over the directions of a sphere from a latitude-longitude picture, as it stands.
#pragma once

#include <memory>

#include "shabon/film/number.h"
#include "shabon/math/raster.h"
#include "shabon/math/vec.h"

namespace shabon::film {

// u is the azimuth, 0.5 + atan2(x, -z)/(2 pi), v = acos(y)/pi from the top, as on the sphere of the room geometry,
// (25).
struct LatitudeMap {
  std::shared_ptr<const math::Raster> nm;  // one channel
  double repeat_u = 1, repeat_v = 1;       // so many times around and from pole to pole
};

// Thickness in nm in the direction `from_centre`, of any length.
template <class Number>
Number thickness_nm(const LatitudeMap& map, const math::Vec3<Number>& from_centre) {
  using std::sqrt;
  constexpr double pi = std::numbers::pi;
  const Number across = sqrt(from_centre.x * from_centre.x + from_centre.z * from_centre.z);
  const Number azimuth = angle_of<Number>(from_centre.x, Number(0.0) - from_centre.z),
               polar = angle_of<Number>(across, from_centre.y);
  constexpr int lanes = lane_count_of<Number>();
  alignas(64) double u[lanes], v[lanes];
  to_lanes((azimuth * Number(0.5 / pi) + Number(0.5)) * Number(map.repeat_u), u);
  to_lanes(polar * Number(map.repeat_v / pi), v);
  // Beyond the poles of a picture that is there once lies no other copy of it.
  const auto edge_v = map.repeat_v == 1 ? math::RasterEdge::clamp : math::RasterEdge::repeat;
  for (int i = 0; i < lanes; ++i) {
    float value = 0;
    bilinear(*map.nm, u[i], v[i], math::RasterEdge::repeat, edge_v, &value);
    u[i] = value;
  }
  return from_lanes<Number>(u);
}

}  // namespace shabon::film
