#include "shabon/film/shape_modes.h"

#include <cmath>
#include <numbers>

namespace shabon::film {

namespace {

double legendre(int degree, double x) {
  double before = 1, now = x;
  for (int n = 1; n < degree; ++n) {
    const double next = ((2 * n + 1) * x * now - n * before) / (n + 1);
    before = now, now = next;
  }
  return degree == 0 ? 1 : now;
}

}  // namespace

double shape_frequency_rad_s(const BubbleBody& body, int degree) {
  if (degree < 2) return 0;
  const double l = degree, r = body.radius_m;
  const double stiffness = 2 * body.tension_n_m * (l - 1) * (l + 2);
  const double film = body.density_kg_m3 * body.thickness_m;
  const double air = r * (body.inner_air_kg_m3 / l + body.outer_air_kg_m3 / (l + 1));
  return std::sqrt(stiffness / (r * r * (film + air)));
}

double swing(const BubbleBody& body, const ShapeMode& mode, double time_s) {
  const double frequency = shape_frequency_rad_s(body, mode.degree);
  const double damping = frequency / (2 * mode.quality);
  const double turns = std::sqrt(frequency * frequency - damping * damping) * time_s;
  const double phase = mode.phase_deg * std::numbers::pi / 180;
  return mode.amplitude_m / body.radius_m * std::exp(-damping * time_s) * std::cos(turns + phase);
}

double radius_m(const BubbleBody& body, const std::vector<ShapeMode>& modes, const math::Vec3d& from_centre,
                double time_s) {
  double relative = 1;
  for (const ShapeMode& mode : modes) {
    const double now = swing(body, mode, time_s);
    const double cosine = math::dot(from_centre, math::normalize(mode.axis));
    relative += now * legendre(mode.degree, cosine) - now * now / (2 * mode.degree + 1);
  }
  return body.radius_m * relative;
}

double excess_pressure_pa(const BubbleBody& body) { return 4 * body.tension_n_m / body.radius_m; }

}  // namespace shabon::film
