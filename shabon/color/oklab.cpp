#include "shabon/color/oklab.h"

#include <cmath>

namespace shabon::color {

namespace {

constexpr Matrix3 oklab_to_cone_roots = inverse(cone_roots_to_oklab);

}  // namespace

Oklab linear_srgb_to_oklab(LinearRgb colour) {
  Vector3 roots = multiply(srgb_to_cones, Vector3{colour.r, colour.g, colour.b});
  for (double& v : roots) v = std::cbrt(v);
  const Vector3 lab = multiply(cone_roots_to_oklab, roots);
  return {lab[0], lab[1], lab[2]};
}

LinearRgb oklab_to_linear_srgb(Oklab colour) {
  Vector3 cones = multiply(oklab_to_cone_roots, Vector3{colour.L, colour.a, colour.b});
  for (double& v : cones) v = v * v * v;
  const Vector3 rgb = multiply(cones_to_srgb, cones);
  return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace shabon::color
