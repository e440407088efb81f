#include "shabon/geometry/shapes/lobed_sphere.h"

#include "shabon/geometry/lobes.h"
#include "shabon/geometry/shapes/sphere.h"

namespace shabon::geometry {

using math::Vec3d;

Legendre legendre(int degree, double x) {
  Legendre before{1, 0, 0}, now{x, 1, 0};
  if (degree == 0) return before;
  for (int n = 1; n < degree; ++n) {
    const double k = 2 * n + 1;
    const Legendre next{(k * x * now.value - n * before.value) / (n + 1), before.slope + k * now.value,
                        before.bend + k * now.slope};
    before = now, now = next;
  }
  return now;
}

LobeBounds bounds_of(const LobedSphere& lobed) {
  LobeBounds bounds{lobed.mean, lobed.mean, 0, 0};
  for (const Lobe& lobe : lobed.lobes) {
    const double size = std::abs(lobe.amplitude), square = 0.5 * lobe.degree * (lobe.degree + 1);
    bounds.low -= size, bounds.high += size;
    bounds.slope += size * std::sqrt(square), bounds.bend += size * square;
  }
  constexpr double rounding = 1e-9;
  bounds.low *= 1 - rounding, bounds.high *= 1 + rounding;
  return bounds;
}

double radius_at(const LobedSphere& lobed, Vec3d n) {
  double radius = lobed.mean;
  for (const Lobe& lobe : lobed.lobes) radius += lobe.amplitude * legendre(lobe.degree, dot(n, lobe.axis)).value;
  return radius;
}

RadiusSlope slope_at(const LobedSphere& lobed, Vec3d n) {
  RadiusSlope at{lobed.mean, {}};
  for (const Lobe& lobe : lobed.lobes) {
    const double x = dot(n, lobe.axis);
    const Legendre p = legendre(lobe.degree, x);
    at.radius += lobe.amplitude * p.value;
    at.gradient = at.gradient + (lobe.axis - n * x) * (lobe.amplitude * p.slope);
  }
  return at;
}

double area_per_sample(const LobedSphere& lobed, Vec3d p) {
  const RadiusSlope at = slope_at(lobed, math::normalize(p));
  return 4 * std::numbers::pi * at.radius * std::sqrt(at.radius * at.radius + dot(at.gradient, at.gradient));
}

// By Gauss's rule in height and the trapezoid rule around: exact but for rounding, as nothing changes faster over the
// surface than the highest lobe, and the root in the element of area does not make it much faster.
double area(const LobedSphere& lobed) {
  int highest = 0;
  for (const Lobe& lobe : lobed.lobes) highest = std::max(highest, lobe.degree);
  const int rows = 40 + 8 * highest, around = 2 * rows;
  double sum = 0;
  for (int i = 0; i < rows; ++i) {
    double y = std::cos(std::numbers::pi * (i + 0.75) / (rows + 0.5));
    for (int k = 0; k < 6; ++k) {
      const Legendre p = legendre(rows, y);
      y -= p.value / p.slope;
    }
    const double slope = legendre(rows, y).slope, weight = 1 / ((1 - y) * (1 + y) * slope * slope);
    const double r = std::sqrt((1 - y) * (1 + y));
    double row = 0;
    for (int k = 0; k < around; ++k) {
      const double phi = 2 * std::numbers::pi * k / around;
      row += area_per_sample(lobed, {r * std::cos(phi), y, r * std::sin(phi)});
    }
    sum += weight * row / around;
  }
  return sum;
}

CanonicalPoint point_at(const LobedSphere& lobed, Vec3d p) {
  const CanonicalPoint on_sphere = point_at(SphereCap{}, p);
  const Vec3d n = on_sphere.normal, around = on_sphere.tangent_u;
  const RadiusSlope at = slope_at(lobed, n);
  return {n * at.radius, math::normalize(n * at.radius - at.gradient),
          math::normalize(n * dot(at.gradient, around) + around * at.radius), on_sphere.u, on_sphere.v};
}

Vec3d sample(const LobedSphere& lobed, double u1, double u2) {
  const Vec3d n = sample(SphereCap{}, u1, u2);
  return n * radius_at(lobed, n);
}

}  // namespace shabon::geometry
