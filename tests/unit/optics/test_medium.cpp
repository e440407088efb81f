#include "shabon/optics/medium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

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
  EXPECT_EQ(medium.outside_range_note(WavelengthRange{1, 1e9}), "");
}

TEST(Medium, FormulaContinuesOverTheRenderedRangeAndThenHolds) {
  const DispersionFormula formula = dispersion_formula(2, {0, 1, 0.01}).value();
  const Medium medium = Medium::formula(formula, {400, 1000}, {"x", "", ""}).value();
  EXPECT_EQ(medium.index(360), formula.index(360));
  EXPECT_EQ(medium.index(300), formula.index(360));
  EXPECT_EQ(medium.index(1000), formula.index(1000));
  EXPECT_EQ(medium.index(2000), formula.index(1000));
  const Medium narrow = Medium::formula(formula, {400, 700}, {"x", "", ""}).value();
  EXPECT_EQ(narrow.index(830), formula.index(830));
  EXPECT_EQ(narrow.index(900), formula.index(830));
  EXPECT_TRUE(medium.covers(400) && medium.covers(1000));
  EXPECT_FALSE(medium.covers(399.9) || medium.covers(1000.1));
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
  EXPECT_EQ(medium.outside_range_note(std::vector{300.0, 800.0}),
            "t: its source covers 400..700 nm; below, the value at 400 nm is held; above, the value at 700 nm is held");
  const Medium point = Medium::table({{550, 2, 0}}, {}).value();
  EXPECT_EQ(point.index(400), 2.0);
  EXPECT_TRUE(point.is_lossless());
}

// The note says what index() does at the wavelengths asked, and nothing of others.
TEST(Medium, NotesSayWhatWasDone) {
  const DispersionFormula formula = dispersion_formula(2, {0, 1, 0.01}).value();
  const Medium narrow = Medium::formula(formula, {400, 700}, {"x", "", ""}).value();
  const Medium wide = Medium::formula(formula, {182, 1129}, {"w", "", ""}).value();
  const Medium lossy = Medium::formula(formula, {300, 900}, {"l", "", ""}, {{500, 0.1}, {600, 0.2}}).value();
  const Medium mixed = Medium::mixture({{narrow, 0.5}, {wide, 0.5}}, {"m", "", ""}).value();
  const std::string covers_x = "x: its source covers 400..700 nm";
  const auto note = [](const Medium& medium, std::vector<double> wavelengths_nm) {
    return medium.outside_range_note(wavelengths_nm);
  };
  EXPECT_EQ(note(narrow, {400, 700}), "");
  EXPECT_EQ(note(narrow, {399}), covers_x + "; below, the formula is continued");
  EXPECT_EQ(note(narrow, {830, 360}), covers_x + "; below, the formula is continued; above, the formula is continued");
  EXPECT_EQ(note(narrow, {300}), covers_x + "; below, the value at 360 nm is held");
  EXPECT_EQ(note(narrow, {300, 380}),
            covers_x + "; below, the formula is continued to 360 nm and its value there held beyond");
  EXPECT_EQ(note(narrow, {500, 2000}), covers_x + "; above, the value at 830 nm is held");
  EXPECT_EQ(note(narrow, {800, 2000}),
            covers_x + "; above, the formula is continued to 830 nm and its value there held beyond");
  EXPECT_EQ(note(wide, {830, 1e4}), "w: its source covers 182..1129 nm; above, the value at 1129 nm is held");
  EXPECT_EQ(note(lossy, {450}), "l: its source covers 500..600 nm; below, n follows the formula, k of 500 nm is held");
  EXPECT_EQ(note(mixed, {300}), "m: " + covers_x + "; below, the value at 360 nm is held");
  EXPECT_EQ(narrow.outside_range_note(rendered_range_nm), note(narrow, {360, 830}));
  EXPECT_EQ(narrow.outside_range_note(WavelengthRange{300, 500}), note(narrow, {300, 399}));
  EXPECT_EQ(narrow.outside_range_note(WavelengthRange{900, 1000}), note(narrow, {900, 1000}));
}

// A formula is continued only as far as it is one: not through a resonance, nor to where n^2 < 0.
TEST(Medium, ContinuationStopsBeforeAResonance) {
  const DispersionFormula resonance = dispersion_formula(2, {0, 1, 0.16}).value();  // pole at 400 nm
  const Medium medium = Medium::formula(resonance, {500, 900}, {"x", "", ""}).value();
  const double held = medium.index(360).real();
  EXPECT_LT(held, 8);
  EXPECT_GT(held, medium.index(500).real());
  EXPECT_EQ(medium.index(400), held);
  EXPECT_NE(medium.outside_range_note(rendered_range_nm).find(" nm and its value there held beyond"),
            std::string::npos);
  const DispersionFormula negative = dispersion_formula(3, {2, -4, 2}).value();  // n^2 = 2 - 4 L^2
  const Medium falling = Medium::formula(negative, {300, 600}, {"x", "", ""}).value();
  EXPECT_GT(falling.index(830).real(), 0);
  EXPECT_LT(falling.index(830).real(), falling.index(600).real());
  for (const WavelengthRange range : {WavelengthRange{300, 900}, {600, 300}, {0, 500}, {500, 500}})
    EXPECT_FALSE(Medium::formula(resonance, range, {}).ok());
  EXPECT_FALSE(Medium::formula(negative, {300, 800}, {}).ok());
  EXPECT_FALSE(Medium::formula({77, {1}}, {300, 800}, {}).ok());
  EXPECT_FALSE(Medium::formula(resonance, {500, 900}, {}, {{950, 0}, {960, 0}}).ok());
}

TEST(Medium, MixtureFollowsLorentzAndLorenz) {
  const Medium water = find_medium("water").value(), silver = find_medium("Ag").value();
  const auto polarisability = [](Complex n) { return (n * n - 1.0) / (n * n + 2.0); };
  for (const double share : {0.0, 0.3, 1.0}) {
    const Medium mixture = Medium::mixture({{water, 1 - share}, {silver, share}}, {}).value();
    for (double nm = 300; nm < 1000; nm += 7) {
      const Complex expected = (1 - share) * polarisability(water.index(nm)) + share * polarisability(silver.index(nm));
      EXPECT_NEAR(std::abs(polarisability(mixture.index(nm)) - expected), 0, 1e-12) << share << " " << nm;
      EXPECT_GE(mixture.index(nm).imag(), 0);
      EXPECT_GE(mixture.index(nm).real(), 0);
    }
  }
  const Medium same = Medium::mixture({{water, 0.25}, {water, 0.75}}, {}).value();
  EXPECT_NEAR(same.index(500).real(), water.index(500).real(), 1e-14);
  EXPECT_EQ(same.range_nm(), water.range_nm());
  EXPECT_TRUE(same.is_lossless());
  EXPECT_FALSE(Medium::mixture({{water, 0.25}, {water, 0.7}}, {}).ok());
  EXPECT_FALSE(Medium::mixture({{water, 1.5}, {water, -0.5}}, {}).ok());
  EXPECT_FALSE(Medium::mixture({}, {}).ok());
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

// No two media answer to one name.
TEST(Media, NamesAreUnique) {
  std::set<std::string> names;
  for (const MediumEntry& entry : media_library()) {
    EXPECT_TRUE(names.insert(lower(entry.name)).second) << entry.name;
    for (const std::string_view alias : entry.aliases) EXPECT_TRUE(names.insert(lower(alias)).second) << alias;
  }
}

// What every entry of the library must offer.
TEST(Media, EveryEntryIsUsable) {
  for (const MediumEntry& entry : media_library()) {
    EXPECT_EQ(entry.name, entry.medium.name());
    EXPECT_EQ(find_medium(lower(entry.name)), entry.medium);
    for (const std::string_view alias : entry.aliases) EXPECT_EQ(find_medium(lower(alias)), entry.medium) << alias;
    EXPECT_FALSE(entry.medium.description().empty()) << entry.name;
    EXPECT_FALSE(entry.medium.source().empty()) << entry.name;
    for (double nm = rendered_range_nm.first_nm; nm <= rendered_range_nm.last_nm; ++nm) {
      EXPECT_GT(entry.medium.index(nm).real(), 0) << entry.name << nm;
      EXPECT_GE(entry.medium.index(nm).imag(), 0) << entry.name << nm;
    }
  }
  EXPECT_EQ(find_medium("Air")->index(500), 1.0);
  EXPECT_FALSE(find_medium("ai"));
  EXPECT_EQ(medium_named("soda_lime").errors()[0].message, "unknown medium 'soda_lime'; did you mean 'soda-lime'?");
  EXPECT_EQ(medium_named("Q").errors()[0].message.rfind("unknown medium 'Q'; known: vacuum, air,", 0), 0u);
  EXPECT_EQ(medium_named("watr").errors()[0].message, "unknown medium 'watr'; did you mean 'water'?");
}

TEST(Medium, ClearMediaLoseTheirAbsorption) {
  for (const MediumEntry& entry : media_library()) {
    const Medium bare = entry.medium.without_absorption();
    EXPECT_TRUE(bare.is_lossless()) << entry.name;
    double most_k = 0;
    for (int nm = 360; nm <= 830; ++nm) most_k = std::max(most_k, entry.medium.index(nm).imag());
    EXPECT_EQ(entry.medium.is_clear(), most_k <= most_k_of_clear) << entry.name;
    if (entry.medium.form() == "mixture") continue;
    for (const double nm : {360.0, 551.5, 830.0})
      EXPECT_EQ(bare.index(nm), std::complex<double>(entry.medium.index(nm).real())) << entry.name;
  }
  EXPECT_TRUE(medium_named("glass")->is_clear());
  EXPECT_FALSE(medium_named("glass")->is_lossless());
  EXPECT_FALSE(medium_named("Ag")->is_clear());
}

// A hundredth of soap in water is not worth a warning; two fifths of glycerol are.
TEST(Medium, SmallPartsOfAMixtureAreNotWarnedOf) {
  const WavelengthRange visible{360, 830};
  EXPECT_EQ(medium_named("soap")->outside_range_note(visible), "");
  EXPECT_EQ(medium_named("soap-glycerol")->outside_range_note(visible),
            "soap-glycerol: glycerol: its source covers 589.3..1050 nm; below, the formula is continued");
}

}  // namespace
}  // namespace shabon::optics
