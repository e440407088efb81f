// Newton's colours of a free water film under D65 against an independent chain: tmm for the spectra, colour-science for
// the colours (the heads of the files in tests/data/color name versions and conventions).
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "read_csv.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"

namespace {

using namespace shabon::color;

constexpr double tolerance = 1e-9;
const Illuminant& d65() { return *find_illuminant("D65"); }

struct Film {
  double index, thickness_nm, incidence_deg;

  double cos_1() const { return std::cos(incidence_deg * std::numbers::pi / 180); }
  double cos_2() const { return std::sqrt(1 - (1 - cos_1() * cos_1()) / (index * index)); }
  double rho_s() const { return std::pow((cos_1() - index * cos_2()) / (cos_1() + index * cos_2()), 2); }
  double rho_p() const { return std::pow((index * cos_1() - cos_2()) / (index * cos_1() + cos_2()), 2); }
  double delta(double wavelength_nm) const {  // phase between neighbouring beams
    return 4 * std::numbers::pi * index * thickness_nm * cos_2() / wavelength_nm;
  }
};

// Equation (10): the free film without loss in real form, all beams summed.
double airy(double rho, double delta) {
  const double f = 4 * rho * std::pow(std::sin(delta / 2), 2) / std::pow(1 - rho, 2);
  return f / (1 + f);
}

// Equation (11): two beams, the second one reversed in sign.
double two_beam(double rho, double delta) {
  const double first = std::sqrt(rho), second = first * (1 - rho);
  return rho + second * second + 2 * first * second * std::cos(delta - std::numbers::pi);
}

template <class Model>
Spectrum reflectance(const Film& film, Model model) {
  Spectrum spectrum;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double delta = film.delta(wavelength_nm(i));
    spectrum[i] = (model(film.rho_s(), delta) + model(film.rho_p(), delta)) / 2;
  }
  return spectrum;
}

void expect_colour(const CsvRow& row, const Spectrum& spectrum) {
  SCOPED_TRACE(testing::Message() << row.at("d_nm") << " nm at " << row.at("theta_deg") << " degrees");
  const Xyz xyz = reflectance_to_xyz(spectrum, d65());
  EXPECT_NEAR(xyz.x, row.at("X"), tolerance);
  EXPECT_NEAR(xyz.y, row.at("Y"), tolerance);
  EXPECT_NEAR(xyz.z, row.at("Z"), tolerance);
  const LinearRgb linear = xyz_to_linear_srgb(xyz);
  EXPECT_NEAR(linear.r, row.at("linDR"), tolerance);
  EXPECT_NEAR(linear.g, row.at("linDG"), tolerance);
  EXPECT_NEAR(linear.b, row.at("linDB"), tolerance);

  // The encoded columns were made from the file's four-digit linear ones, so they start from those here too.
  const EncodedRgb encoded = encode_srgb(LinearRgb{row.at("linR"), row.at("linG"), row.at("linB")});
  EXPECT_NEAR(encoded.r, row.at("encR"), tolerance);
  EXPECT_NEAR(encoded.g, row.at("encG"), tolerance);
  EXPECT_NEAR(encoded.b, row.at("encB"), tolerance);
  const auto bytes = to_bytes(encoded);
  EXPECT_EQ(bytes[0], row.at("r8"));
  EXPECT_EQ(bytes[1], row.at("g8"));
  EXPECT_EQ(bytes[2], row.at("b8"));
}

TEST(NewtonColours, ExactFilm) {
  constexpr double water = 1.333;
  for (const CsvRow& row : read_csv("color/newton_d65.csv"))
    expect_colour(row, reflectance({water, row.at("d_nm"), row.at("theta_deg")}, airy));
}

TEST(NewtonColours, TwoBeamFilm) {
  for (const CsvRow& row : read_csv("color/two_beam_newton_d65.csv"))
    expect_colour(row, reflectance({4.0 / 3, row.at("d_nm"), row.at("theta_deg")}, two_beam));
}

TEST(NewtonColours, PlainSumsAtOneNanometre) {
  constexpr double water = 1.333;
  for (const CsvRow& row : read_csv("color/integration_1nm.csv")) {
    const Xyz xyz = reflectance_to_xyz(reflectance({water, row.at("d_nm"), 0}, airy), d65());
    EXPECT_NEAR(xyz.x, row.at("X"), tolerance) << row.at("d_nm");
    EXPECT_NEAR(xyz.y, row.at("Y"), tolerance) << row.at("d_nm");
    EXPECT_NEAR(xyz.z, row.at("Z"), tolerance) << row.at("d_nm");
  }
}

}  // namespace
