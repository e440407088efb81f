// A clear sky and the ground below it: A. J. Preetham, P. Shirley, B. Smits, "A practical analytic model for daylight",
// SIGGRAPH 1999. The luminance and the chromaticity of each direction follow R. Perez's distribution; the spectrum is
// the sum of the CIE's components of daylight (41) that has that colour.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "shabon/color/matrix3.h"
#include "shabon/color/spectrum.h"
#include "shabon/math/vec.h"
#include "shabon/scene/lights/select.h"
#include "shabon/scene/lights/softbox.h"

namespace shabon::scene {

// One quantity over the sky: at_zenith F(view)/F(zenith), F = (1 + a e^(b/cos zenith angle)) (1 + c e^(d g) + e cos^2
// g) with g the angle to the sun in radians; the paper's equations 3 and 4.
struct PerezDistribution {
  double a = 0, b = 0, c = 0, d = 0, e = 0;
  double factor = 0;  // at_zenith / F(zenith)

  template <class T>
  T at(const T& cos_zenith, const T& to_sun_rad, const T& cos_to_sun) const {
    using std::exp2;
    const T fall = T(1) + T(a) * exp2(T(b * std::numbers::log2e) / cos_zenith);
    const T glow = T(1) + T(c) * exp2(T(d * std::numbers::log2e) * to_sun_rad) + T(e) * cos_to_sun * cos_to_sun;
    return T(factor) * fall * glow;
  }
};

struct SkyLight {
  // The luminance as the renderer counts it, and the CIE 1931 chromaticity.
  PerezDistribution luminance, x, y;
  math::Vec3d sun{0, 1, 0};  // towards it, unit length
  // Channels first, first + 1 and first + 2 are the components, the first one with Y = 1.
  int first_channel = 0;
  color::Matrix3 components_of_xyz{};
  std::array<double, 3> component_y{};  // Y of each component
  // The wavelengths at which a sum of components can vanish first: S1/S0 and S2/S0 there.
  std::vector<std::array<double, 2>> limits;
  // The ground's light, the same from everywhere below; its fourth channel is the sun's.
  std::array<double, 4> ground{};
  int ground_channels = 3;

  // What of each component comes from a direction above the horizon. No sum of them is negative anywhere: a colour that
  // would need it is moved towards the mean daylight, S0.
  template <class T>
  std::array<T, 3> components(const math::Vec3<T>& direction) const;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    const std::array<T, 3> sky = components(direction);
    for (int k = 0; k < ground_channels; ++k) {
      const T below = T(ground[static_cast<std::size_t>(k)]);
      const T here = k < 3 ? select(direction.y > T(0), sky[static_cast<std::size_t>(k)], below)
                           : select(direction.y > T(0), T(0), below);
      coefficients[first_channel + k] = coefficients[first_channel + k] + here;
    }
  }
};

template <class T>
std::array<T, 3> SkyLight::components(const math::Vec3<T>& direction) const {
  using std::atan2, std::max, std::min, std::sqrt;
  constexpr double lowest_cosine = 1e-3;  // within 0.06 degrees of the horizon the sky changes no more
  constexpr double least_share = 1e-3;    // of S0 that is left at every wavelength
  const T cos_zenith = max(direction.y, T(lowest_cosine));
  // The chord to the sun keeps its digits where the angle is small.
  const T dx = direction.x - T(sun.x), dy = direction.y - T(sun.y), dz = direction.z - T(sun.z);
  const T chord_squared = min(dx * dx + dy * dy + dz * dz, T(4));
  const T to_sun_rad = T(2) * atan2(sqrt(chord_squared), sqrt(T(4) - chord_squared));
  const T cos_to_sun = T(1) - T(0.5) * chord_squared;
  const T bright = max(luminance.at(cos_zenith, to_sun_rad, cos_to_sun), T(0));
  const T x_here = x.at(cos_zenith, to_sun_rad, cos_to_sun), y_here = y.at(cos_zenith, to_sun_rad, cos_to_sun);
  const T per_y = bright / y_here;
  const std::array<T, 3> xyz{x_here * per_y, bright, (T(1) - x_here - y_here) * per_y};
  std::array<T, 3> sum;
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] =
        T(components_of_xyz[i][0]) * xyz[0] + T(components_of_xyz[i][1]) * xyz[1] + T(components_of_xyz[i][2]) * xyz[2];
  T taken = T(0);
  for (const auto& [s1, s2] : limits) taken = max(taken, -(sum[1] * T(s1) + sum[2] * T(s2)));
  const T most = T(1 - least_share) * sum[0];
  const T kept = select(taken > most, most / max(taken, T(1e-30)), T(1));
  sum[1] = sum[1] * kept;
  sum[2] = sum[2] * kept;
  const T y_left = sum[0] * T(component_y[0]) + sum[1] * T(component_y[1]) + sum[2] * T(component_y[2]);
  const T again = bright / max(y_left, T(1e-30));
  for (T& component : sum) component = component * again;
  return sum;
}

struct SkyConditions {
  double sun_elevation_deg = 40, sun_azimuth_deg = 0;  // 0..90; azimuth from -z towards +x
  double turbidity = 3;                                // color::turbidity_range
  double scale = 1;  // 1: a white card that lies in the open, under this sky and this sun, has Y = 1
  bool sun = true;   // whether its disk is there; the sky stays as it is
  double ground_albedo = 0.2;
};

struct SkyAndSun {
  SkyLight sky;
  std::optional<RoundSoftbox> sun;
  std::vector<color::Spectrum> channels;  // three, and one of the sun
  double unit_cd_m2 = 0;                  // the luminance that counts as Y = 1 at scale 1
};

// `first_channel` is where the channels will stand among those of the scene.
SkyAndSun sky_and_sun(const SkyConditions& conditions, int first_channel);

}  // namespace shabon::scene
