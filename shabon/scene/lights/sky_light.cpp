#include "shabon/scene/lights/sky_light.h"

#include "shabon/base/units.h"
#include "shabon/color/daylight.h"
#include "shabon/color/sunlight.h"
#include "shabon/color/xyz.h"

namespace shabon::scene {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double luminous_efficacy_lm_w = 683.002;  // of ybar = 1: the definition of the candela, SI brochure 2019

double radians(double degrees) { return Radians(Degrees(degrees)).value; }

// The paper's appendix A.2: the distributions' coefficients are linear in the turbidity.
PerezDistribution luminance_of(double t) {
  return {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
}
PerezDistribution x_of(double t) {
  return {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
}
PerezDistribution y_of(double t) {
  return {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
}

// The zenith's luminance in kcd/m^2, of the paper's appendix A.2.
double zenith_kcd_m2(double t, double sun_zenith_rad) {
  const double chi = (4.0 / 9 - t / 120) * (pi - 2 * sun_zenith_rad);
  return (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
}

// The zenith's chromaticity there: rows for turbidity squared, turbidity and 1, columns for the cube of the sun's
// zenith angle down to 1.
using ZenithFit = std::array<std::array<double, 4>, 3>;
constexpr ZenithFit zenith_x{
    {{0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr ZenithFit zenith_y{
    {{0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}}};

double at_zenith(const ZenithFit& fit, double t, double angle) {
  double result = 0;
  for (const auto& row : fit) result = result * t + ((row[0] * angle + row[1]) * angle + row[2]) * angle + row[3];
  return result;
}

void normalize(PerezDistribution& distribution, double zenith_value, double sun_zenith_rad) {
  distribution.factor = 1;
  distribution.factor = zenith_value / distribution.at(1.0, sun_zenith_rad, std::cos(sun_zenith_rad));
}

// The corners of the convex hull of all (S1/S0, S2/S0): where no corner vanishes nothing does. Counter-clockwise, by
// A. M. Andrew's monotone chain (Information Processing Letters 9 (1979) 216).
std::vector<std::array<double, 2>> limits_of(const std::array<color::Spectrum, 3>& components) {
  std::vector<std::array<double, 2>> points, hull;
  for (std::size_t i = 0; i < components[0].size(); ++i)
    points.push_back({components[1][i] / components[0][i], components[2][i] / components[0][i]});
  std::sort(points.begin(), points.end());
  const auto chain = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto point = begin; point != end; ++point) {
      const auto turns_right = [&] {
        const auto &a = hull[hull.size() - 2], &b = hull.back();
        return (b[0] - a[0]) * ((*point)[1] - a[1]) - (b[1] - a[1]) * ((*point)[0] - a[0]) <= 0;
      };
      while (hull.size() >= start + 2 && turns_right()) hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

// Components under a diffuse white that faces upwards, divided by pi: the mean over the sky by its cosine.
std::array<double, 3> on_white_card(const SkyLight& sky) {
  constexpr int rings = 128, steps = 512;  // to 1e-4
  std::array<double, 3> sum{};
  for (int ring = 0; ring < rings; ++ring) {
    const double across = std::sqrt((ring + 0.5) / rings), up = std::sqrt(1 - (ring + 0.5) / rings);
    for (int step = 0; step < steps; ++step) {
      const double azimuth = 2 * pi * (step + 0.5) / steps;
      const auto here = sky.components(math::Vec3d{across * std::sin(azimuth), up, -across * std::cos(azimuth)});
      for (std::size_t k = 0; k < 3; ++k) sum[k] += here[k] / (rings * steps);
    }
  }
  return sum;
}

double y_of(const color::Spectrum& spectrum) { return color::radiance_to_xyz(spectrum).y; }

// The sky in kcd/m^2.
SkyLight sky_of(const SkyConditions& conditions, const std::array<color::Spectrum, 3>& components) {
  const double t = conditions.turbidity, zenith_rad = radians(90 - conditions.sun_elevation_deg);
  SkyLight sky;
  sky.luminance = luminance_of(t);
  sky.x = x_of(t);
  sky.y = y_of(t);
  normalize(sky.luminance, zenith_kcd_m2(t, zenith_rad), zenith_rad);
  normalize(sky.x, at_zenith(zenith_x, t, zenith_rad), zenith_rad);
  normalize(sky.y, at_zenith(zenith_y, t, zenith_rad), zenith_rad);
  const double azimuth = radians(conditions.sun_azimuth_deg), across = std::sin(zenith_rad);
  sky.sun = math::normalize(math::Vec3d{across * std::sin(azimuth), std::cos(zenith_rad), -across * std::cos(azimuth)});
  color::Matrix3 xyz_of_components{};
  for (std::size_t k = 0; k < 3; ++k) {
    const color::Xyz xyz = color::radiance_to_xyz(components[k]);
    xyz_of_components[0][k] = xyz.x;
    xyz_of_components[1][k] = sky.component_y[k] = xyz.y;
    xyz_of_components[2][k] = xyz.z;
  }
  sky.components_of_xyz = color::inverse(xyz_of_components);
  sky.limits = limits_of(components);
  return sky;
}

}  // namespace

SkyAndSun sky_and_sun(const SkyConditions& conditions, int first_channel) {
  constexpr double per_kilo = 1000;
  SkyAndSun result;
  std::array<color::Spectrum, 3> components = color::daylight_components();
  const double s0_y = y_of(components[0]);
  for (color::Spectrum& component : components)
    for (double& value : component) value /= s0_y;
  result.channels.assign(components.begin(), components.end());
  result.sky = sky_of(conditions, components);
  result.sky.first_channel = first_channel;

  // The sun's disk has the same radiance everywhere, its irradiance over its projected solid angle.
  color::Spectrum sunlight = color::sun_irradiance(conditions.sun_elevation_deg, conditions.turbidity);
  const double sunlight_y = y_of(sunlight), half_angle = radians(color::sun_half_angle_deg);
  const double sun_klx = luminous_efficacy_lm_w * sunlight_y / per_kilo;
  for (double& value : sunlight) value /= sunlight_y;
  const double disk = pi * std::sin(half_angle) * std::sin(half_angle);

  std::array<double, 3> card = on_white_card(result.sky);
  const double sun_card = sun_klx * result.sky.sun.y / pi;
  const double sky_card =
      card[0] * result.sky.component_y[0] + card[1] * result.sky.component_y[1] + card[2] * result.sky.component_y[2];
  const double unit = sky_card + sun_card;  // kcd/m^2
  const double factor = conditions.scale / unit;
  result.unit_cd_m2 = unit * per_kilo;
  result.sky.luminance.factor *= factor;
  for (std::size_t k = 0; k < 3; ++k) result.sky.ground[k] = conditions.ground_albedo * factor * card[k];
  if (conditions.sun) {
    result.channels.push_back(sunlight);
    result.sky.ground_channels = 4;
    result.sky.ground[3] = conditions.ground_albedo * factor * sun_card;
    result.sun = round_softbox(result.sky.sun, half_angle, first_channel + 3, factor * sun_klx / disk);
  }
  return result;
}

}  // namespace shabon::scene
