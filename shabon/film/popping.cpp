#include "shabon/film/popping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::film {

using std::numbers::pi;

double taylor_culick_m_s(double tension_n_m, double density_kg_m3, double thickness_m) {
  return std::sqrt(2 * tension_n_m / (density_kg_m3 * thickness_m));
}

double popping_duration_s(const BubbleBody& body, const PoppingDesc& popping) {
  const double speed = taylor_culick_m_s(body.tension_n_m, body.density_kg_m3, body.thickness_m);
  return pi * body.radius_m / speed * popping.slow_motion;
}

Hole hole_at(const BubbleBody& body, const PoppingDesc& popping, double time_s) {
  const double share = (time_s - popping.start_s) / popping_duration_s(body, popping);
  Hole hole;
  hole.angle_rad = pi * std::clamp(share, 0.0, 1.0);
  const double swept = 1 - std::cos(hole.angle_rad), ring = body.radius_m * std::sin(hole.angle_rad);
  hole.rim_volume_m3 = 2 * pi * body.radius_m * body.radius_m * body.thickness_m * swept;
  if (hole.angle_rad <= 0) return hole;
  hole.rim_radius_m = std::sqrt(hole.rim_volume_m3 / (2 * pi * pi * std::max(ring, 1e-12)));
  if (hole.angle_rad > pi / 2 && hole.rim_radius_m > ring) {
    hole.angle_rad = pi;
    hole.rim_radius_m = 0;
  }
  return hole;
}

}  // namespace shabon::film
