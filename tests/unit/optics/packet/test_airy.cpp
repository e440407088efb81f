// The general layer against the exact reference: absorbing films, different media on both sides, total and frustrated
// total reflection.
#include "shabon/optics/packet/airy.h"

#include <gtest/gtest.h>

#include <complex>
#include <functional>

#include "film_cases.h"
#include "shabon/optics/reference/airy.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {
namespace {

using Complex = std::complex<double>;

// All in double, so far below what is required of packets.
constexpr double stated = 1e-9;
static_assert(stated <= required);

// One ray meeting one layer, for 16 wavelengths.
struct LayerCase {
  double n1;
  Complex n2[lanes], n3[lanes];
  double thickness_nm;
  Incidence incidence;
  double wavelength_nm[lanes];

  std::string lane_text(int i) const {
    char text[200];
    std::snprintf(text, sizeof text,
                  "n1 %.7g n2 %.7g+%.7gi n3 %.7g+%.7gi thickness %.7g nm cos %.9g wavelength %.6g nm", n1, n2[i].real(),
                  n2[i].imag(), n3[i].real(), n3[i].imag(), thickness_nm, incidence.cos_i, wavelength_nm[i]);
    return text;
  }
};

math::complex_packet<double, lanes> packed(const Complex (&z)[lanes]) {
  double re[lanes], im[lanes];
  for (int i = 0; i < lanes; ++i) re[i] = z[i].real(), im[i] = z[i].imag();
  return {Double::load(re), Double::load(im)};
}

AmplitudeLanes<lanes> kernel(const LayerCase& layer) {
  const LayerLanes<lanes> at{math::complex_packet<double, lanes>(Double(layer.n1)), packed(layer.n2), packed(layer.n3),
                             Double(1.0) / Double::load(layer.wavelength_nm)};
  return airy_amplitudes(at, layer.thickness_nm, layer.incidence.cos_i);
}

struct Errors {
  Worst amplitudes, powers;

  void expect() const {
    amplitudes.expect_within(stated, "amplitudes");
    powers.expect_within(stated, "powers");
  }
};

// Transmitted amplitudes are ratios of fields and exceed 1 between different media: relative to them there.
void compare(const LayerCase& layer, Errors& errors) {
  const AmplitudeLanes<lanes> fast = kernel(layer);
  for (int i = 0; i < lanes; ++i) {
    const auto where = [&] { return layer.lane_text(i); };
    const auto see = [&](const math::complex_packet<double, lanes>& z, Complex exact) {
      errors.amplitudes.see(std::abs(Complex(z.re[i], z.im[i]) - exact) / std::max(1.0, std::abs(exact)), where);
    };
    const Amplitudes exact = airy_amplitudes(layer.n1, layer.n2[i], layer.n3[i], layer.thickness_nm, layer.incidence,
                                             layer.wavelength_nm[i]);
    see(fast.r_s, exact.r_s);
    see(fast.r_p, exact.r_p);
    see(fast.t_s, exact.t_s);
    see(fast.t_p, exact.t_p);
    const Powers powers = powers_of(exact, layer.n1, layer.n3[i], layer.incidence);
    errors.powers.see(std::abs(norm(fast.t_s)[i] * fast.transmission_s[i] - powers.T_s), where);
    errors.powers.see(std::abs(norm(fast.t_p)[i] * fast.transmission_p[i] - powers.T_p), where);
    errors.powers.see(std::abs(norm(fast.r_s)[i] - powers.R_s), where);
    errors.powers.see(std::abs(norm(fast.r_p)[i] - powers.R_p), where);
  }
}

Complex rounded(double n, double k) { return {as_float(n), as_float(k)}; }

// Angles 0..89.9 degrees, more of them near the end; thickness 0..2000 nm, more of it near 0.
LayerCase random_ray(Pcg32& random) {
  LayerCase layer;
  layer.n1 = as_float(random() & 1 ? 1.0 : random.uniform(1, 2.5));
  layer.incidence = incidence_from_cos(
      cosine_of_degrees(random() % 4 ? random.uniform(0, 89.9) : 89.9 - 10 * std::pow(random.uniform(), 2)));
  layer.thickness_nm = as_float(2000 * std::pow(random.uniform(), 2));
  const double shift = random.uniform();
  for (int i = 0; i < lanes; ++i) layer.wavelength_nm[i] = as_float(360 + 470 * (i + shift) / lanes);
  return layer;
}

using RandomIndex = std::function<Complex(Pcg32&)>;

Complex transparent(Pcg32& random) { return rounded(random.uniform(1, 4), 0); }
Complex barely_absorbing(Pcg32& random) { return rounded(random.uniform(1, 3), std::pow(10, random.uniform(-9, -2))); }
Complex absorbing(Pcg32& random) { return rounded(random.uniform(0.3, 5), random.uniform(0, 1)); }
Complex metallic(Pcg32& random) { return rounded(random.uniform(0.05, 3), random.uniform(0.5, 8)); }

// The same index for all lanes of a case, a little dispersed.
void compare_random(const RandomIndex& film, const RandomIndex& beyond, bool same_media, std::uint64_t seed) {
  Errors errors;
  Pcg32 random(seed);
  for (int k = 0; k < 15000; ++k) {
    LayerCase layer = random_ray(random);
    const Complex n2 = film(random), n3 = same_media ? Complex(layer.n1) : beyond(random);
    for (int i = 0; i < lanes; ++i) {
      layer.n2[i] = rounded(n2.real() * (1 + 0.002 * i), n2.imag() * (1 + 0.02 * i));
      layer.n3[i] = same_media ? n3 : rounded(n3.real() * (1 + 0.002 * i), n3.imag());
    }
    compare(layer, errors);
  }
  errors.expect();
}

TEST(Airy, FreeFilms) { compare_random(transparent, transparent, true, 1); }
TEST(Airy, TransparentFilmsOnGlass) { compare_random(transparent, transparent, false, 2); }
TEST(Airy, BarelyAbsorbingFreeFilms) { compare_random(barely_absorbing, transparent, true, 3); }
TEST(Airy, AbsorbingFreeFilms) { compare_random(absorbing, transparent, true, 4); }
TEST(Airy, AbsorbingFilmsOnGlass) { compare_random(absorbing, transparent, false, 5); }
TEST(Airy, TransparentFilmsOnMetal) { compare_random(transparent, metallic, false, 6); }
TEST(Airy, MetalFilmsInAir) { compare_random(metallic, transparent, true, 7); }
TEST(Airy, MetalFilmsOnMetal) { compare_random(metallic, metallic, false, 8); }

// Films of lower index than the outer media: beyond the critical angle only thin ones let light through.
TEST(Airy, TotalAndFrustratedTotalReflection) {
  Errors errors;
  Pcg32 random(9);
  for (int k = 0; k < 40000; ++k) {
    LayerCase layer = random_ray(random);
    layer.n1 = as_float(random.uniform(1.2, 3));
    const double critical_sin = random.uniform(0.3, 0.99);
    const Complex n2 = rounded(layer.n1 * critical_sin, 0);
    const Complex n3 = k % 2 ? Complex(layer.n1) : rounded(random.uniform(1, 3), 0);
    // Half of the angles lie around the critical one, down to a distance that double cannot tell from it.
    if (random() & 1) {
      const double sin_i = std::min(
          0.999998, n2.real() / layer.n1 * (1 + std::pow(10, random.uniform(-17, -2)) * (random() & 1 ? 1 : -1)));
      layer.incidence = {std::sqrt((1 - sin_i) * (1 + sin_i)), sin_i};
    }
    for (int i = 0; i < lanes; ++i) layer.n2[i] = n2, layer.n3[i] = n3;
    compare(layer, errors);
  }
  errors.expect();
}

LayerCase layer_at(double n1, Complex n2, Complex n3, double thickness_nm, Incidence incidence) {
  LayerCase layer;
  layer.n1 = n1;
  layer.thickness_nm = thickness_nm;
  layer.incidence = incidence;
  for (int i = 0; i < lanes; ++i) layer.n2[i] = n2, layer.n3[i] = n3, layer.wavelength_nm[i] = 370 + 29 * i;
  return layer;
}

// n1 sin = n2 in exact numbers: the wave runs along the film, and the amplitudes have a limit.
TEST(Airy, ExactlyAtTheCriticalAngle) {
  Errors errors;
  for (const double thickness_nm : {0.0, 1.0, 100.0, 2000.0})
    for (const double n3 : {1.25, 1.0, 0.75, 1.5}) compare(layer_at(1.25, 0.75, n3, thickness_nm, {0.8, 0.6}), errors);
  errors.expect();
}

TEST(Airy, AlongTheFilm) {
  Errors errors;
  for (const double cos_i : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
    for (const double thickness_nm : {0.0, 0.1, 100.0, 550.0, 2000.0})
      for (const Complex n2 : {Complex(1), Complex(1.0001), Complex(1.5), Complex(0.9), Complex(1, 1e-9),
                               Complex(1.5, 0.1), Complex(0.2, 3)})
        for (const Complex n3 : {Complex(1), Complex(1.5), Complex(0.2, 3)})
          compare(layer_at(1, n2, n3, thickness_nm, incidence_from_cos(cos_i)), errors);
  errors.expect();
}

TEST(Airy, NoFilmIsTheBareInterface) {
  Errors errors;
  for (const double angle_deg : {0.0, 30.0, 60.0, 85.0})
    for (const Complex n3 : {Complex(1.5), Complex(1), Complex(0.2, 3)})
      compare(layer_at(1, {2.5, 0.3}, n3, 0, incidence_from_cos(cosine_of_degrees(angle_deg))), errors);
  errors.expect();
}

// Nothing comes through, nothing overflows.
TEST(Airy, OpaqueFilms) {
  Errors errors;
  for (const double thickness_nm : {1e3, 1e5, 1e7, 1e9})
    for (const double angle_deg : {0.0, 45.0, 89.0})
      compare(layer_at(1, {0.2, 3.5}, 1.5, thickness_nm, incidence_from_cos(cosine_of_degrees(angle_deg))), errors);
  errors.expect();
}

TEST(Airy, NoEnergyIsLostWithoutAbsorption) {
  Worst worst;
  Pcg32 random(10);
  for (int k = 0; k < 20000; ++k) {
    LayerCase layer = random_ray(random);
    const Complex n2 = transparent(random), n3 = transparent(random);
    for (int i = 0; i < lanes; ++i) layer.n2[i] = n2, layer.n3[i] = n3;
    const AmplitudeLanes<lanes> x = kernel(layer);
    for (int i = 0; i < lanes; ++i) {
      const auto where = [&] { return layer.lane_text(i); };
      worst.see(std::abs(norm(x.r_s)[i] + norm(x.t_s)[i] * x.transmission_s[i] - 1), where);
      worst.see(std::abs(norm(x.r_p)[i] + norm(x.t_p)[i] * x.transmission_p[i] - 1), where);
    }
  }
  worst.expect_within(1e-11, "R + T - 1");
}

}  // namespace
}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
