// A swept layer against the same films one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shabon/base/random.h"
#include "shabon/desk/sweep.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

std::vector<double> grid(double first, double last, double step) {
  std::vector<double> values;
  for (double value = first; value <= last; value += step) values.push_back(value);
  return values;
}

optics::Stack stack_of(std::string_view expression) {
  const auto stack = optics::parse_stack(expression);
  EXPECT_TRUE(stack.ok()) << expression;
  return stack ? *stack : optics::Stack{};
}

double one_by_one(const Sweep& sweep, double thickness_nm, double wavelength_nm) {
  optics::Stack stack = sweep.stack;
  stack.layers[sweep.layer].thickness_nm = thickness_nm;
  return unpolarised(film_powers(stack, sweep.interference, sweep.incidence, wavelength_nm), sweep.side);
}

// The largest difference to the films one by one, on both sides.
double largest_difference(Sweep sweep, const std::vector<double>& wavelengths_nm) {
  double largest = 0;
  for (const Side side : {Side::reflected, Side::transmitted}) {
    sweep.side = side;
    const auto spectra = swept_spectra(sweep, wavelengths_nm);
    EXPECT_TRUE(spectra.ok());
    if (!spectra) return INFINITY;
    EXPECT_EQ(spectra->size(), sweep.thicknesses_nm.size());
    for (std::size_t t = 0; t < spectra->size(); ++t) {
      EXPECT_EQ((*spectra)[t].size(), wavelengths_nm.size());
      for (std::size_t w = 0; w < wavelengths_nm.size(); ++w) {
        const double expected = one_by_one(sweep, sweep.thicknesses_nm[t], wavelengths_nm[w]);
        const double difference = std::abs((*spectra)[t][w] - expected);
        largest = difference <= largest ? largest : difference;  // NaN wins
      }
    }
  }
  return largest;
}

struct Case {
  const char* expression;
  std::size_t layer;
};

// Lossless, absorbing, metallic, evanescent, opaque and zero layers above, below and in place of the swept one.
constexpr Case cases[] = {
    {"air | water 1nm | air", 0},
    {"air | 1.47 1nm | water", 0},
    {"air | SiO2 1nm | Si", 0},
    {"air | TiO2 1nm | Ti", 0},
    {"1 | 1.38 99.6nm | 2.2 1nm | 1.52", 1},
    {"1 | 2.2 1nm | 1.38 99.6nm | 1.52", 0},
    {"air | (ZnS 58nm | MgF2 99nm)^5 | glass 1nm | Ag 40nm | air", 10},
    {"air | Ag 30nm | SiO2 1nm | Ag 30nm | glass", 1},
    {"air | 1.5+0.2i 1nm | 2+0.1i 300nm | 1.4", 0},
    {"air | Au 1nm | glass", 0},
    {"1.52 | 1.0 1nm | 1.52", 0},  // frustrated total reflection
    {"1.52 | 1.3 1nm | 1.2 200nm | 1.1 1um | 1", 0},
    {"1.52 | Ag 50nm | 1.33 1nm | 1", 1},  // a plasmon
    {"1 | Al 2um | 1.5 1nm | 1", 1},       // nothing comes through
    {"1 | Al 200um | 1.5 1nm | 1", 1},     // not even as a number
    {"1 | 1.5 1nm | Al 200um | 1", 0},
    {"1.5+0.001i | 2 1nm | 1.5", 0},  // an absorbing first medium
    {"1 | 1 1nm | 1", 0},             // nothing at all
};

TEST(Sweep, IsTheFilmsOneByOne) {
  for (const Case& c : cases) {
    for (const double angle_deg : {0.0, 20.0, 45.0, 70.0, 89.0, 89.99}) {
      Sweep sweep{stack_of(c.expression),
                  c.layer,
                  {0, 0.001, 1, 37, 250.5, 400, 1500, 5000},
                  optics::incidence_from(Degrees(angle_deg))};
      EXPECT_LT(largest_difference(sweep, grid(360, 830, 9.7)), 1e-12) << c.expression << " " << angle_deg;
    }
  }
}

TEST(Sweep, HoldsOnBothSidesOfTheCriticalAngle) {
  Sweep sweep{stack_of("1.5 | 1.2 1nm | 1.5"), 0, {0, 100, 1000, 4000}};
  const double critical_deg = std::asin(1.2 / 1.5) * 180 / std::numbers::pi;
  for (const double off_deg : {0.0, 1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 0.1})
    for (const double sign : {-1.0, 1.0}) {
      sweep.incidence = optics::incidence_from(Degrees(critical_deg + sign * off_deg));
      EXPECT_LT(largest_difference(sweep, {400, 500, 700}), 1e-12) << sign * off_deg;
    }
}

// A resonance as narrow as the reflections are strong, where no phase is left to blame: the film of no thickness.
TEST(Sweep, ALayerOfNoThicknessIsNotThereAtGrazingIncidence) {
  for (const double angle_deg : {89.99, 89.9999, 89.999999}) {
    Sweep sweep{stack_of("1 | 1.5 1nm | 1"), 0, {0}, optics::incidence_from(Degrees(angle_deg))};
    for (const Side side : {Side::reflected, Side::transmitted}) {
      sweep.side = side;
      const auto spectra = swept_spectra(sweep, std::vector<double>{400, 700});
      ASSERT_TRUE(spectra.ok());
      EXPECT_NEAR(spectra->front()[0], side == Side::reflected ? 0 : 1, 1e-12) << angle_deg;
      EXPECT_NEAR(spectra->front()[1], side == Side::reflected ? 0 : 1, 1e-12) << angle_deg;
    }
  }
}

TEST(Sweep, HoldsForRandomStacks) {
  Pcg32 random(7);
  for (int i = 0; i < 200; ++i) {
    optics::Stack stack{
        optics::Medium::constant(random.uniform(1, 2)), {}, optics::Medium::constant(random.uniform(1, 3))};
    const auto count = static_cast<std::size_t>(random.uniform(1, 12));
    for (std::size_t j = 0; j < count; ++j) {
      const double k = random.uniform() < 0.5 ? 0 : std::pow(10, random.uniform(-4, 0.6));
      stack.layers.push_back({optics::Medium::constant({random.uniform(0.5, 3), k}), random.uniform(0, 300), true});
    }
    Sweep sweep{stack,
                static_cast<std::size_t>(random.uniform(0, static_cast<double>(count))),
                {0, 3, 50, 400, 2000},
                optics::incidence_from(Degrees(random.uniform(0, 89)))};
    EXPECT_LT(largest_difference(sweep, {365, 455.5, 589, 770}), 1e-12) << i;
  }
}

// What cannot be cut at the layer: models without phases, incoherent layers, 90 degrees.
TEST(Sweep, KnowsWhateverTheReferenceKnows) {
  Sweep film{stack_of("air | water 1nm | glass"), 0, {0, 50, 400}, optics::incidence_from(Degrees(30))};
  for (const auto& model : optics::interference_models) {
    film.interference = model.value;
    EXPECT_EQ(largest_difference(film, {400, 600}) < 1e-12, true) << model.name;
  }
  Sweep grazing{stack_of("air | water 1nm | air"), 0, {0, 50, 400}, optics::incidence_from(Degrees(90))};
  EXPECT_EQ(largest_difference(grazing, {400, 600}), 0);
  Sweep window{stack_of("air | MgF2 1nm | glass 1mm incoherent | air"), 0, {0, 50, 400}};
  EXPECT_EQ(largest_difference(window, {400, 600}), 0);
}

TEST(Sweep, ColoursAreThoseOfTheSpectra) {
  const auto wavelengths_nm = grid(360, 830, 1);
  for (const Case& c : cases)
    for (const double angle_deg : {0.0, 60.0})
      for (const Side side : {Side::reflected, Side::transmitted}) {
        Sweep sweep{stack_of(c.expression), c.layer, {}, optics::incidence_from(Degrees(angle_deg)), side};
        for (int i = 0; i < 71; ++i) sweep.thicknesses_nm.push_back(i * 11.5);
        const color::Illuminant& lamp = color::illuminants()[1];
        const auto colours = swept_colors(sweep, lamp);
        ASSERT_TRUE(colours.ok());
        for (const std::size_t t : {0u, 1u, 31u, 32u, 70u}) {
          sweep.stack.layers[sweep.layer].thickness_nm = sweep.thicknesses_nm[t];
          const color::Xyz expected =
              color::reflectance_to_xyz(unpolarised(sweep.stack, sweep.interference, sweep.incidence, side), lamp);
          EXPECT_NEAR((*colours)[t].x, expected.x, 1e-12) << c.expression;
          EXPECT_NEAR((*colours)[t].y, expected.y, 1e-12) << c.expression;
          EXPECT_NEAR((*colours)[t].z, expected.z, 1e-12) << c.expression;
        }
      }
}

TEST(Sweep, RefusesWhatItCannotSweep) {
  const Sweep film{stack_of("air | water 1nm | air"), 0, {100}};
  const auto message = [](const Sweep& sweep) {
    const auto colours = swept_colors(sweep, color::illuminants()[0]);
    const auto spectra = swept_spectra(sweep, std::vector<double>{500});
    EXPECT_EQ(colours.ok(), spectra.ok());
    return colours ? "" : colours.errors().front().message;
  };
  EXPECT_EQ(message(film), "");
  Sweep broken = film;
  broken.layer = 1;
  EXPECT_EQ(message(broken), "there is no layer 2 to sweep: the stack has 1");
  broken = film;
  for (const double thickness_nm : {-1.0, 1.1e9, std::nan("")}) {
    broken.thicknesses_nm = {100, thickness_nm};
    EXPECT_NE(message(broken).find("expected thicknesses of 0..1e+09 nm, got"), std::string::npos) << message(broken);
  }
  broken = {stack_of("air | water 1nm | glass 1nm | air"), 0, {100}};
  broken.interference = optics::Interference::two_beam;
  EXPECT_NE(message(broken).find("airy"), std::string::npos);
}

}  // namespace
}  // namespace shabon::desk
