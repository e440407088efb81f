#include "shabon/optics/medium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shabon/base/text.h"
#include "shabon/optics/media.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;

TEST(Medium, ConstantIsTheSameEverywhere) {
  const Medium medium = Medium::constant({2.4, 0.01});
  EXPECT_EQ(medium.index(1), Complex(2.4, 0.01));
  EXPECT_EQ(medium.index(1e6), Complex(2.4, 0.01));
  EXPECT_EQ(medium.name(), "2.4+0.01i");
  EXPECT_EQ(Medium::constant({0, 3}).name(), "3i");
  EXPECT_EQ(Medium::constant(1.5).name(), "1.5");
  EXPECT_TRUE(medium.is_constant());
  EXPECT_FALSE(medium.is_lossless());
  EXPECT_TRUE(medium.covers(5));
  EXPECT_FALSE(medium.range_nm());
  EXPECT_EQ(medium.outside_range_note(), "");
}

TEST(Medium, FormulaContinuesOverTheRenderedRangeAndThenHolds) {
  const DispersionFormula formula = dispersion_formula(2, {0, 1, 0.01}).value();
  const Medium medium = Medium::formula(formula, {400, 1000}, {"x", "", ""});
  EXPECT_EQ(medium.index(360), formula.index(360));
  EXPECT_EQ(medium.index(300), formula.index(360));
  EXPECT_EQ(medium.index(1000), formula.index(1000));
  EXPECT_EQ(medium.index(2000), formula.index(1000));
  const Medium narrow = Medium::formula(formula, {400, 700}, {"x", "", ""});
  EXPECT_EQ(narrow.index(830), formula.index(830));
  EXPECT_EQ(narrow.index(900), formula.index(830));
  EXPECT_TRUE(medium.covers(400) && medium.covers(1000));
  EXPECT_FALSE(medium.covers(399.9) || medium.covers(1000.1));
  EXPECT_EQ(medium.outside_range_note(), "x: wavelengths outside 400..1000 nm: the formula is continued");
  EXPECT_TRUE(medium.is_lossless());
  EXPECT_FALSE(medium.is_constant());
}

TEST(Medium, TableIsLinearAndHoldsItsEnds) {
  const Medium medium = Medium::table({{400, 1.5, 0}, {500, 1.7, 0.2}, {700, 1.1, 0}}, {"t", "", ""}).value();
  EXPECT_EQ(medium.index(399), Complex(1.5, 0));
  EXPECT_EQ(medium.index(400), Complex(1.5, 0));
  EXPECT_NEAR(medium.index(425).real(), 1.55, 1e-15);
  EXPECT_NEAR(medium.index(425).imag(), 0.05, 1e-15);
  EXPECT_EQ(medium.index(500), Complex(1.7, 0.2));
  EXPECT_NEAR(medium.index(600).real(), 1.4, 1e-15);
  EXPECT_EQ(medium.index(1e5), Complex(1.1, 0));
  EXPECT_EQ(medium.range_nm(), (WavelengthRange{400, 700}));
  EXPECT_FALSE(medium.is_lossless());
  EXPECT_NE(medium.outside_range_note().find("end values are held"), std::string::npos);
  const Medium point = Medium::table({{550, 2, 0}}, {}).value();
  EXPECT_EQ(point.index(400), 2.0);
  EXPECT_TRUE(point.is_lossless());
}

TEST(Medium, TableRefusesBadRows) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::vector<IndexSample>, std::string>> cases = {
      {{}, "at least one row"},
      {{{400, 1, 0}, {400, 1, 0}}, "row 2: expected rising wavelengths"},
      {{{400, nan, 0}}, "row 1: expected finite"},
      {{{0, 1, 0}}, "row 1: expected a wavelength > 0"},
      {{{400, -1, 0}}, "row 1: expected n >= 0"},
      {{{400, 1, -1e-3}}, "row 1: expected k >= 0"},
      {{{400, 0, 0}}, "row 1: expected an index other than 0"},
  };
  for (const auto& [rows, message] : cases) {
    const auto medium = Medium::table(rows, {});
    ASSERT_FALSE(medium.ok()) << message;
    EXPECT_NE(medium.errors()[0].message.find(message), std::string::npos) << medium.errors()[0].message;
  }
}

TEST(Medium, EqualityIsOfNumbersNotOfNames) {
  EXPECT_EQ(find_medium("air"), find_medium("vacuum"));
  EXPECT_EQ(Medium(), Medium::constant(1));
  EXPECT_EQ(find_medium("water"), find_medium("Water"));
  EXPECT_FALSE(Medium::constant(1.333) == *find_medium("water"));
}

TEST(Dispersion, BothSellmeierFormsAgree) {
  const auto by_resonance = dispersion_formula(1, {0.1, 1.2, 0.1, 0.3, 9}).value();
  const auto by_square = dispersion_formula(2, {0.1, 1.2, 0.01, 0.3, 81}).value();
  EXPECT_NEAR(by_resonance.index(500), by_square.index(500), 1e-15);
  EXPECT_NEAR(std::pow(by_square.index(500), 2), 1.1 + 1.2 * 0.25 / 0.24 + 0.3 * 0.25 / (0.25 - 81), 1e-14);
}

TEST(Dispersion, RefusesWhatItCannotEvaluate) {
  EXPECT_FALSE(dispersion_formula(77, {1}).ok());
  EXPECT_FALSE(dispersion_formula(2, {}).ok());
  EXPECT_FALSE(dispersion_formula(2, {0, 1}).ok());
  EXPECT_FALSE(dispersion_formula(2, {0, 1, std::nan("")}).ok());
}

// What every entry of the library must offer.
TEST(Media, EveryEntryIsUsable) {
  for (const MediumEntry& entry : media_library()) {
    EXPECT_EQ(entry.name, entry.medium.name());
    EXPECT_EQ(find_medium(lower(entry.name)), entry.medium);
    EXPECT_FALSE(entry.medium.description().empty()) << entry.name;
    EXPECT_FALSE(entry.medium.source().empty()) << entry.name;
    for (double nm = rendered_range_nm.first_nm; nm <= rendered_range_nm.last_nm; ++nm) {
      EXPECT_GT(entry.medium.index(nm).real(), 0) << entry.name << nm;
      EXPECT_GE(entry.medium.index(nm).imag(), 0) << entry.name << nm;
    }
  }
  EXPECT_EQ(find_medium("Air")->index(500), 1.0);
  EXPECT_FALSE(find_medium("ai"));
  EXPECT_EQ(medium_named("watr").errors()[0].message, "unknown medium 'watr'; did you mean 'water'?");
}

}  // namespace
}  // namespace shabon::optics
