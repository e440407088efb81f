// Colours of films whose fringes are finer than the sums of 1 nm: against sums fine enough for them, and towards films
// without phase.
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/color/lab.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/fringes.h"
#include "shabon/desk/sweep.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

const color::Illuminant& d65() { return *color::find_illuminant("D65"); }

optics::Stack stack_of(const std::string& expression) {
  const auto stack = optics::parse_stack(expression);
  EXPECT_TRUE(stack.ok()) << expression;
  return stack ? *stack : optics::Stack{};
}

color::Xyz colour_of(const optics::Stack& stack, optics::Incidence incidence, Side side,
                     optics::Interference model = optics::Interference::airy) {
  return color::reflectance_to_xyz(unpolarised(stack, model, incidence, side), d65());
}

// Each nanometre by `looks` wavelengths, evenly spaced.
color::Xyz finely(const optics::Stack& stack, optics::Incidence incidence, Side side, int looks,
                  optics::Interference model = optics::Interference::airy) {
  color::Spectrum share{};
  for (std::size_t i = 0; i < share.size(); ++i)
    for (int j = 0; j < looks; ++j) {
      const double wavelength_nm = color::wavelength_nm(i) + (j + 0.5) / looks - 0.5;
      share[i] += unpolarised(film_powers(stack, model, incidence, wavelength_nm), side) / looks;
    }
  return color::reflectance_to_xyz(share, d65());
}

double difference(color::Xyz a, color::Xyz b) {
  const color::Xyz white = color::white_point(d65());
  return color::ciede2000(color::xyz_to_lab(a, white), color::xyz_to_lab(b, white));
}

struct Film {
  std::string stack;
  std::size_t layer;  // one that may be swept
  int looks;          // enough for its fringes
  double tolerance = 0.02;
};

// One thick layer, two of them, thick ones beside thin ones, metals and absorption.
const Film films[] = {
    {"air | water 30um | air", 0, 40, 0.05},  // at the border, one half of it a plain sum
    {"air | water 50um | air", 0, 40},
    {"air | water 100um | air", 0, 40},
    {"air | water 128um | air", 0, 40},
    {"air | 1.5 300um | water", 0, 100},
    {"air | MgF2 100nm | glass 100um | air", 0, 40},
    {"air | MgF2 100nm | glass 100um | air", 1, 40},
    {"air | 1.4 60um | 1.6 60um | 1.5", 0, 40},
    {"air | 1.4 60um | 1.6 60um | 1.5", 1, 40},
    {"air | 1.5 80um | 1 80um | 1.5 80um | air", 1, 100},
    {"air | 1.5+0.0001i 90um | Al", 0, 40},
    {"1.5 | 1.3 100um | 1.5", 0, 40},
};

TEST(FineFringes, ColoursAreThoseOfFineSums) {
  for (const Film& film : films)
    for (const double angle_deg : {0.0, 50.0}) {
      const optics::Incidence incidence = optics::incidence_from(Degrees(angle_deg));
      const optics::Stack stack = stack_of(film.stack);
      const color::Xyz fine = finely(stack, incidence, Side::reflected, film.looks);
      EXPECT_LT(difference(colour_of(stack, incidence, Side::reflected), fine), film.tolerance)
          << film.stack << " " << angle_deg;
      const color::Xyz through = colour_of(stack, incidence, Side::transmitted);
      EXPECT_NEAR(through.y, finely(stack, incidence, Side::transmitted, film.looks).y, 2e-4) << film.stack;
    }
}

// Whether it is asked alone or in a series, and whichever layer is swept.
TEST(FineFringes, AFilmHasOneColour) {
  for (const Film& film : films)
    for (const Side side : {Side::reflected, Side::transmitted}) {
      const optics::Incidence incidence = optics::incidence_from(Degrees(20));
      const optics::Stack stack = stack_of(film.stack);
      const double thickness_nm = stack.layers[film.layer].thickness_nm;
      const auto swept = swept_colors({stack, film.layer, {100, thickness_nm, 0}, incidence, side}, d65());
      ASSERT_TRUE(swept.ok());
      const color::Xyz alone = colour_of(stack, incidence, side);
      EXPECT_LT(difference((*swept)[1], alone), 0.01) << film.stack << " layer " << film.layer;
      if (stack.layers.size() == 1) {
        EXPECT_EQ((*swept)[1], alone) << film.stack;
      }
    }
}

// The thicker, the nearer: from some hundred micrometres to a metre nobody sees that the film is coherent.
TEST(FineFringes, VeryThickFilmsTendToTheIncoherentOnes) {
  for (const std::string thickness : {"200um", "350um", "1mm", "3.7mm", "2cm", "99.9cm"})
    for (const std::string film : {"air | water # | air", "air | 1.6 # | Si", "air | MgF2 100nm | glass # | 1.2"}) {
      std::string expression = film;
      expression.replace(expression.find('#'), 1, thickness);
      const optics::Stack stack = stack_of(expression);
      optics::Stack incoherent = stack;
      incoherent.layers.back().coherent = false;
      for (const double angle_deg : {0.0, 60.0}) {
        const optics::Incidence incidence = optics::incidence_from(Degrees(angle_deg));
        for (const Side side : {Side::reflected, Side::transmitted})
          EXPECT_LT(difference(colour_of(stack, incidence, side), colour_of(incoherent, incidence, side)), 0.05)
              << expression << " " << angle_deg;
      }
    }
}

// What no single cut describes: incoherent neighbours and the two-beam model.
TEST(FineFringes, HoldWhereTheReferenceComputes) {
  const optics::Incidence incidence = optics::incidence_from(Degrees(30));
  const optics::Stack two_beam = stack_of("air | water 110um | air");
  EXPECT_LT(difference(colour_of(two_beam, incidence, Side::reflected, optics::Interference::two_beam),
                       finely(two_beam, incidence, Side::reflected, 40, optics::Interference::two_beam)),
            0.02);
  const optics::Stack window = stack_of("air | 1.4 110um | glass 1mm incoherent | air");
  EXPECT_LT(difference(colour_of(window, incidence, Side::reflected), finely(window, incidence, Side::reflected, 40)),
            0.02);
  const auto swept = swept_colors({window, 0, {110'000}, incidence}, d65());
  ASSERT_TRUE(swept.ok());
  EXPECT_EQ(swept->front(), colour_of(window, incidence, Side::reflected));
}

// Below a quarter of a fringe within 1 nm the plain sum stays what it is, to the last bit.
TEST(FineFringes, ThinFilmsKeepThePlainSum) {
  for (const std::string expression :
       {"air | water 1.5um | air", "air | water 10um | air", "air | 1.4 4um | 2 2um | 1.5"}) {
    const optics::Stack stack = stack_of(expression);
    color::Spectrum plain{};
    for (std::size_t i = 0; i < plain.size(); ++i)
      plain[i] =
          unpolarised(film_powers(stack, optics::Interference::airy, {}, color::wavelength_nm(i)), Side::reflected);
    EXPECT_EQ(unpolarised(stack, optics::Interference::airy, {}, Side::reflected), plain) << expression;
  }
}

TEST(FineFringes, LooksCoverTheNanometre) {
  for (const double per_nm : {0.3, 1.0, 5.0, 10.9, 11.3, 400.0, 2e4}) {
    const std::vector<double> looks = looks_within_nm({per_nm, per_nm, 0});
    double mean = 0;
    std::complex<double> wave = 0;
    for (const double offset_nm : looks) {
      EXPECT_LE(std::abs(offset_nm), 0.55);
      mean += offset_nm / static_cast<double>(looks.size());
      wave += std::polar(1.0, 2 * std::numbers::pi * per_nm * offset_nm) / static_cast<double>(looks.size());
    }
    EXPECT_NEAR(mean, 0, 0.02) << per_nm;
    // The mean of a fringe over the nanometre.
    EXPECT_NEAR(std::abs(wave), std::abs(std::sin(std::numbers::pi * per_nm) / (std::numbers::pi * per_nm)), 0.035)
        << per_nm;
  }
  EXPECT_EQ(looks_within_nm({0.25, 0.25, 0}), std::vector<double>{0});
}

}  // namespace
}  // namespace shabon::desk
