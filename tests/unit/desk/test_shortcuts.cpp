// The shortcuts where their answers are known, and the comparison that is made of them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "shabon/color/lab.h"
#include "shabon/color/rgb.h"
#include "shabon/desk/comparison.h"
#include "shabon/desk/shortcuts.h"
#include "shabon/desk/shortcuts_gltf.h"
#include "shabon/desk/shortcuts_walls.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

using Complex = std::complex<double>;

const color::Illuminant& d65() { return color::illuminants()[0]; }

std::vector<double> thicknesses(double last_nm, double step_nm) {
  std::vector<double> values;
  for (double nm = 0; nm <= last_nm; nm += step_nm) values.push_back(nm);
  return values;
}

Sweep film_of(std::string_view expression, double angle_deg = 0, Side side = Side::reflected, std::size_t layer = 0) {
  const auto stack = optics::parse_stack(expression);
  EXPECT_TRUE(stack.ok()) << expression;
  return {*stack, layer, thicknesses(1500, 37), optics::incidence_from(Degrees(angle_deg)), side};
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

const ShortcutSeries& series_of(const Comparison& comparison, std::string_view name) {
  for (const ShortcutSeries& series : comparison.shortcuts)
    if (series.shortcut->name == name) return series;
  ADD_FAILURE() << name;
  return comparison.shortcuts.front();
}

// The largest difference of one shortcut.
double off(const Sweep& film, std::string_view name, const color::Illuminant& lamp = d65()) {
  const Result<Comparison> comparison = compare(film, lamp);
  EXPECT_TRUE(comparison.ok());
  const ShortcutSeries& series = series_of(*comparison, name);
  EXPECT_EQ(series.unfit, "") << name;
  return series.unfit.empty() ? largest(series.differences) : NAN;
}

TEST(Shortcuts, AreNamedOnceAndSayWhoUsesThem) {
  std::set<std::string_view> names;
  for (const Shortcut& shortcut : shortcuts()) {
    EXPECT_TRUE(names.insert(shortcut.name).second) << shortcut.name;
    EXPECT_FALSE(shortcut.description.empty()) << shortcut.name;
    EXPECT_FALSE(shortcut.used_by.empty()) << shortcut.name;
    EXPECT_EQ(find_shortcut(shortcut.name), &shortcut);
  }
  EXPECT_EQ(find_shortcut("Two-Beam"), &shortcuts()[0]);
  EXPECT_EQ(find_shortcut("three-beam"), nullptr);
}

TEST(Shortcuts, NumbersInTheDescriptionsAreThoseUsed) {
  const auto says = [](std::string_view name, double number) {
    return find_shortcut(name)->description.find(format_number(number)) != std::string_view::npos;
  };
  for (const double nm : {red_nm, green_nm, blue_nm}) EXPECT_TRUE(says("three-wavelengths", nm)) << nm;
  EXPECT_TRUE(says("no-dispersion", sodium_nm));
  for (const int nm : {coarse_first_nm, coarse_last_nm, coarse_step_nm}) EXPECT_TRUE(says("coarse-sampling", nm)) << nm;
}

TEST(Shortcuts, NoDispersionIsExactForConstantMedia) {
  for (const double angle_deg : {0.0, 40.0, 75.0})
    for (const Side side : {Side::reflected, Side::transmitted}) {
      EXPECT_EQ(off(film_of("air | 1.333 1nm | air", angle_deg, side), "no-dispersion"), 0);
      EXPECT_EQ(off(film_of("1 | 1.5+0.1i 1nm | 2+3i", angle_deg, side), "no-dispersion"), 0);
    }
  EXPECT_GT(off(film_of("air | water 1nm | air"), "no-dispersion"), 0.1);
}

// No polarisation to average, and Schlick's polynomial is the truth, along the normal.
TEST(Shortcuts, WallsWithoutPolarisationAreExactAlongTheNormal) {
  for (const char* name : {"schlick", "unpolarised-walls"}) {
    for (const Side side : {Side::reflected, Side::transmitted})
      for (const char* expression : {"air | water 1nm | air", "air | biodiesel 1nm | water", "1.52 | 1.38 1nm | 2.3"})
        EXPECT_LT(off(film_of(expression, 0, side), name), 1e-6) << name << " " << expression;
    EXPECT_LT(off(film_of("air | TiO2 1nm | Ti"), name), 1e-6) << name;
    EXPECT_GT(off(film_of("air | water 1nm | air", 60), name), 0.5) << name;
  }
}

// Also where the fringes are finer than 1 nm and the exact colour is a mean; towards films without phase.
TEST(Shortcuts, WallsOfThickFilmsAreMeansToo) {
  for (const char* name : {"schlick", "unpolarised-walls"})
    for (const Side side : {Side::reflected, Side::transmitted}) {
      for (const char* expression : {"air | water 1nm | air", "1.5 | 1.3 1nm | 1.7", "air | 1.5+0.00001i 1nm | Al"}) {
        Sweep film = film_of(expression, 0, side);
        film.thicknesses_nm = {20e3, 30e3, 57.3e3, 99e3, 100.05e3, 128e3, 1e6, 1e7};
        EXPECT_LT(off(film, name), 0.001) << name << " " << expression;
      }
      Sweep bubble = film_of("air | water 1nm | air", 60, side);
      bubble.thicknesses_nm = {5e6, 5.1e6};
      const std::vector<color::Xyz> colors = find_shortcut(name)->colors(bubble, d65(), color::observer_1931());
      EXPECT_NEAR(colors[0].y, colors[1].y, 1e-5) << name;
    }
}

TEST(Shortcuts, WallsLoseNothing) {
  for (const WallAmplitude amplitude : {schlick_amplitude, average_amplitude})
    for (const double angle_deg : {0.0, 30.0, 60.0, 85.0, 89.999, 90.0})
      for (const double n3 : {1.0, 1.2, 2.5})
        for (const double thickness_nm : {0.0, 100.0, 731.0}) {
          const optics::Incidence incidence = optics::incidence_from(Degrees(angle_deg));
          const WallShares shares = FilmOfWalls(amplitude, 1, 1.5, n3, incidence, 550).at(thickness_nm);
          EXPECT_NEAR(shares.reflected + shares.transmitted, 1, 1e-12) << angle_deg << " " << n3;
          EXPECT_GE(shares.reflected, 0);
          if (angle_deg == 90) {
            EXPECT_EQ(shares.reflected, 1);
          }
        }
}

TEST(Shortcuts, SchlickIsHisPolynomialAndTotalBeyondTheCriticalAngle) {
  const optics::Incidence at_60 = optics::incidence_from(Degrees(60));
  const double at_normal = std::pow(0.5 / 2.5, 2);
  EXPECT_NEAR(std::norm(schlick_amplitude(1, at_60, 1, 1.5)), at_normal + (1 - at_normal) * std::pow(0.5, 5), 1e-15);
  EXPECT_LT(schlick_amplitude(1, at_60, 1, 1.5).real(), 0);
  EXPECT_GT(schlick_amplitude(1, at_60, 1.5, 1).real(), 0);
  EXPECT_NEAR(std::norm(schlick_amplitude(1.5, at_60, 1.5, 1)), 1, 1e-12);  // critical at 41.8 degrees
}

TEST(Shortcuts, AverageIsTheMeanOfBothPolarisations) {
  for (const double angle_deg : {0.0, 45.0, 56.3, 80.0}) {
    const optics::Incidence incidence = optics::incidence_from(Degrees(angle_deg));
    const optics::Powers bare = optics::airy(1, 1.5, 1.5, 0, incidence, 550);
    const Complex amplitude = average_amplitude(1, incidence, 1, 1.5);
    EXPECT_NEAR(std::norm(amplitude), (bare.R_s + bare.R_p) / 2, 1e-15);
    EXPECT_LT(amplitude.real(), 0);
  }
}

// A film whose phase does not show: equal media around a wall that is none.
TEST(Shortcuts, EqualMediaHideTheFilm) {
  for (const char* name : {"two-beam", "no-interference", "three-wavelengths", "coarse-sampling"})
    EXPECT_NEAR(off(film_of("1 | 1 1nm | 1"), name), 0, 1e-9) << name;
  EXPECT_LT(off(film_of("1 | 1 1nm | 1.5"), "no-interference"), 1e-9);
  EXPECT_LT(off(film_of("1 | 1 1nm | 1.5"), "two-beam"), 1e-9);
}

// A grey film is the same at three wavelengths as at all; of D65, whose RGB is nearly (1, 1, 1) and exactly itself.
TEST(Shortcuts, ThreeWavelengthsAreExactForAGreyFilm) {
  for (const char* lamp : {"D65", "A", "FL11"})
    EXPECT_LT(off(film_of("1 | 1.5 1nm | 1.5"), "three-wavelengths", *color::find_illuminant(lamp)), 1e-6) << lamp;
  EXPECT_GT(off(film_of("air | water 1nm | air"), "three-wavelengths"), 5);
}

TEST(Shortcuts, CoarseSamplingIsCloseForThinFilmsAndFarForThickOnes) {
  Sweep film = film_of("air | 1.333 1nm | air");
  film.thicknesses_nm = thicknesses(300, 10);
  EXPECT_LT(off(film, "coarse-sampling"), 0.1);
  film.thicknesses_nm = {20'000, 20'010, 20'020};
  EXPECT_GT(off(film, "coarse-sampling"), 1);
}

// By hand: walls, terms and observer of a film with no path difference, where all Gaussians stand at their peak; and
// a path so long that every term has gone.
TEST(Shortcuts, GltfIsWhatTheExtensionSays) {
  const color::LinearRgb thick = gltf_iridescence(1.5, 1e6, 1, {0.04, 0.04, 0.04});
  const double wall = 0.04;  // of the index 1.5, on both sides: the base of 4 % has the same index, so nothing more
  for (const double channel : {thick.r, thick.g, thick.b}) EXPECT_NEAR(channel, wall, 1e-12);
  const color::LinearRgb bubble = gltf_iridescence(1.5, 1e6, 1, {0, 0, 0});
  for (const double channel : {bubble.r, bubble.g, bubble.b}) EXPECT_NEAR(channel, 2 * wall / (1 + wall), 1e-12);
  // No film: the base. The film of no thickness has no wall above; its Gaussians change nothing.
  const color::LinearRgb none = gltf_iridescence(1.5, 0, 1, {0.5, 0.25, 0.04});
  EXPECT_NEAR(none.r, 0.5, 0.01);
  EXPECT_NEAR(none.g, 0.25, 0.01);
  EXPECT_NEAR(none.b, 0.04, 0.01);
}

// Values of the extension's shader code, carried over into Python line by line.
TEST(Shortcuts, GltfIsTheShaderOfTheExtension) {
  struct Case {
    double index, cos_i, thickness_nm;
    color::LinearRgb base, expected;
  };
  constexpr Case cases[] = {
      {1.33, 1, 300, {0, 0, 0}, {0.046257636275858625, 0.076598183229972416, 0.032272901728575262}},
      {1.5, 0.5, 450, {0.04, 0.04, 0.04}, {0.068014659018890006, 0.063934558996147237, 0.075988610109473123}},
      {2, 0.8, 120, {0.56, 0.35, 0.2}, {0.36172761095882405, 0.2955873436915421, 0.19512109574711714}},
      {1.33,
       0.17364817766693041,
       900,
       {0.02, 0.02, 0.02},
       {0.44448145844544967, 0.36348082695570305, 0.42608169540402768}},
  };
  for (const Case& c : cases) {
    const color::LinearRgb rgb = gltf_iridescence(c.index, c.thickness_nm, c.cos_i, c.base);
    EXPECT_NEAR(rgb.r, c.expected.r, 1e-13) << c.thickness_nm;
    EXPECT_NEAR(rgb.g, c.expected.g, 1e-13) << c.thickness_nm;
    EXPECT_NEAR(rgb.b, c.expected.b, 1e-13) << c.thickness_nm;
  }
}

TEST(Shortcuts, GltfIsNearTheTruthForAFilmOnGlass) {
  const Sweep film = film_of("air | 1.33 1nm | 1.7");
  const Result<Comparison> comparison = compare(film, d65());
  ASSERT_TRUE(comparison.ok());
  const double mean = series_of(*comparison, "gltf-iridescence").summary.mean;
  EXPECT_GT(mean, 0.1);
  EXPECT_LT(mean, 10);
}

TEST(Shortcuts, SayWhatTheyDoNotKnow) {
  const auto unfit = [](const Sweep& film) {
    std::set<std::string_view> names;
    const Result<Comparison> comparison = compare(film, d65());
    EXPECT_TRUE(comparison.ok());
    for (const ShortcutSeries& series : comparison->shortcuts) {
      if (!series.unfit.empty()) names.insert(series.shortcut->name);
      EXPECT_EQ(series.differences.size(), series.unfit.empty() ? film.thicknesses_nm.size() : 0u);
    }
    return names;
  };
  using Names = std::set<std::string_view>;
  EXPECT_EQ(unfit(film_of("air | water 1nm | air")), Names{});
  EXPECT_EQ(unfit(film_of("air | water 1nm | air", 0, Side::transmitted)), Names{"gltf-iridescence"});
  EXPECT_EQ(unfit(film_of("glass | water 1nm | air")), Names{"gltf-iridescence"});
  EXPECT_EQ(unfit(film_of("air | MgF2 99nm | ZnS 1nm | glass", 0, Side::reflected, 1)),
            (Names{"two-beam", "gltf-iridescence", "schlick", "unpolarised-walls"}));
}

TEST(Comparison, EveryFilmHasFiniteDifferences) {
  for (const char* expression : {"air | water 0nm | air", "air | TiO2 1nm | Ti", "1.5 | 1 1nm | 1.5",
                                 "1.5+0.01i | 1.3 1nm | Ag", "1 | 1 1nm | 1", "1 | 3+4i 1nm | 1"})
    for (const double angle_deg : {0.0, 41.8103148957786, 60.0, 90.0})
      for (const Side side : {Side::reflected, Side::transmitted}) {
        const Result<Comparison> comparison = compare(film_of(expression, angle_deg, side), d65());
        ASSERT_TRUE(comparison.ok()) << expression;
        for (const ShortcutSeries& series : comparison->shortcuts)
          for (const double difference : series.differences)
            ASSERT_TRUE(difference >= 0 && std::isfinite(difference))
                << expression << " " << series.shortcut->name << " " << angle_deg;
      }
}

TEST(Comparison, DifferencesAreOfTheColoursShown) {
  const Sweep film = film_of("air | water 1nm | air", 45);
  const Result<Comparison> plain = compare(film, d65()), bright = compare(film, d65(), color::observer_1931(), 8);
  ASSERT_TRUE(plain.ok() && bright.ok());
  const color::Xyz white = color::white_point(d65());
  for (std::size_t s = 0; s < shortcuts().size(); ++s) {
    const ShortcutSeries& series = plain->shortcuts[s];
    for (std::size_t t = 0; t < film.thicknesses_nm.size(); ++t)
      EXPECT_EQ(series.differences[t], color::ciede2000(color::xyz_to_lab(plain->exact[t], white),
                                                        color::xyz_to_lab(series.colors[t], white)));
    EXPECT_EQ(series.colors, bright->shortcuts[s].colors);
    EXPECT_NE(series.differences, bright->shortcuts[s].differences) << series.shortcut->name;
  }
}

TEST(Comparison, SummarisesTheSeries) {
  const std::vector<double> at = {10, 20, 30, 40}, differences = {1, 7, 0, 7};
  const DifferenceSummary summary = summary_of(at, differences);
  EXPECT_DOUBLE_EQ(summary.mean, 3.75);
  EXPECT_DOUBLE_EQ(summary.median, 4);
  EXPECT_EQ(summary.percentile_95, 7);
  EXPECT_EQ(summary.largest, 7);
  EXPECT_EQ(summary.largest_at_nm, 20);
  std::vector<double> hundred(100), places(100);
  for (std::size_t i = 0; i < 100; ++i) hundred[i] = static_cast<double>(100 - i), places[i] = static_cast<double>(i);
  EXPECT_EQ(summary_of(places, hundred).percentile_95, 95);
  EXPECT_DOUBLE_EQ(summary_of(places, hundred).median, 50.5);
  EXPECT_EQ(summary_of({}, {}).largest, 0);
}

TEST(Comparison, RefusesAFilmWithoutInterference) {
  const auto error = [](const Sweep& film) {
    const Result<Comparison> comparison = compare(film, d65());
    return comparison ? std::string() : comparison.errors().front().message;
  };
  EXPECT_NE(error(film_of("air | glass 1mm incoherent | air")).find("coherent"), std::string::npos);
  EXPECT_NE(error({*optics::parse_stack("air | water"), 0, {1}}).find("no layer 1"), std::string::npos);
  Sweep negative = film_of("air | water 1nm | air");
  negative.thicknesses_nm = {-1};
  EXPECT_NE(error(negative), "");
}

}  // namespace
}  // namespace shabon::desk
