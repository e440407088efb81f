#include "shabon/desk/shortcuts_gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace shabon::desk {

namespace {

constexpr double pi = std::numbers::pi;

// A Gaussian in wavenumber that stands for a part of the observer. All numbers of this file are those of the extension.
struct Gaussian {
  double weight, position_per_m, variance_per_m2;

  // Its Fourier transform at a path difference, for an Airy term with this phase.
  double at(double path_m, double shift) const {
    const double phase = 2 * pi * path_m;
    return weight * std::sqrt(2 * pi * variance_per_m2) * std::cos(position_per_m * phase + shift) *
           std::exp(-phase * phase * variance_per_m2);
  }
};

constexpr Gaussian x_long{5.4856e-13, 1.6810e+06, 4.3278e+09}, x_short{9.7470e-14, 2.2399e+06, 4.5282e+09},
    y_all{4.4201e-13, 1.7953e+06, 9.3046e+09}, z_all{5.2481e-13, 2.2084e+06, 6.6121e+09};
constexpr double gaussian_scale = 1.0685e-7;

// Also of the extension: XYZ to sRGB with its own digits.
constexpr color::Matrix3 to_rec709 = {color::Vector3{3.2404542, -1.5371385, -0.4985314},
                                      color::Vector3{-0.9692660, 1.8760108, 0.0415560},
                                      color::Vector3{0.0556434, -0.2040259, 1.0572252}};

double square(double x) { return x * x; }

double reflectance_of(double index, double outer_index) {
  return square((index - outer_index) / (index + outer_index));
}

double index_of(double reflectance) {
  const double root = std::sqrt(std::clamp(reflectance, 0.0, 0.9999));
  return (1 + root) / (1 - root);
}

double schlick(double at_normal, double cosine) { return at_normal + (1 - at_normal) * std::pow(1 - cosine, 5); }

// The observer's answer in linear sRGB to one Airy term; the phase shift at the base has a value for each channel.
color::Vector3 sensitivity(double path_m, const color::Vector3& shift) {
  const color::Vector3 xyz = {(x_long.at(path_m, shift[0]) + x_short.at(path_m, shift[0])) / gaussian_scale,
                              y_all.at(path_m, shift[1]) / gaussian_scale, z_all.at(path_m, shift[2]) / gaussian_scale};
  return color::multiply(to_rec709, xyz);
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

color::LinearRgb gltf_iridescence(double film_index, double thickness_nm, double cos_i, color::LinearRgb base) {
  constexpr double vanishing_nm = 0.03;  // a film thinner than this loses its index
  const double index = 1 + (film_index - 1) * smooth_step(0, vanishing_nm, thickness_nm);
  const double cosine = std::sqrt(std::max(0.0, 1 - (1 - square(cos_i)) / square(index)));

  const double outer = schlick(reflectance_of(index, 1), cos_i);
  const double through = 1 - outer;
  constexpr double outer_phase = pi;  // of light that comes from inside, for a film denser than air
  const double path_m = 2 * index * thickness_nm * cosine * 1e-9;
  const std::array<double, 3> channels = {base.r, base.g, base.b};
  color::Vector3 light{}, term{}, root{}, phase{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double base_index = index_of(channels[i]);
    const double inner = schlick(reflectance_of(base_index, index), cosine);
    phase[i] = outer_phase + (base_index < index ? pi : 0);
    const double both = std::clamp(outer * inner, 1e-5, 0.9999);
    root[i] = std::sqrt(both);
    const double repeated = square(through) * inner / (1 - both);
    light[i] = outer + repeated;
    term[i] = repeated - through;
  }
  for (int m = 1; m <= 2; ++m) {
    const color::Vector3 answer = sensitivity(m * path_m, {m * phase[0], m * phase[1], m * phase[2]});
    for (std::size_t i = 0; i < 3; ++i) {
      term[i] *= root[i];
      light[i] += term[i] * 2 * answer[i];
    }
  }
  return {std::max(0.0, light[0]), std::max(0.0, light[1]), std::max(0.0, light[2])};
}

}  // namespace shabon::desk
