#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/daylight.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/planck.h"
#include "shabon/color/table_columns.h"
#include "shabon/color/temperature.h"
#include "shabon/color/xyz.h"

namespace {

using namespace shabon::color;
using shabon::lower;

double largest_difference(const Spectrum& a, const Spectrum& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(Illuminants, AreTheColumnsOfTheirTables) {
  for (const shabon::Table& table : shabon::tables::lamp_series()) {
    for (std::size_t column = 1; column < table.columns.size(); ++column) {
      const Illuminant* lamp = find_illuminant(table.column_names[column]);
      ASSERT_TRUE(lamp) << table.column_names[column];
      EXPECT_TRUE(std::equal(lamp->power.begin(), lamp->power.end(), table.columns[column].begin())) << lamp->name;
      EXPECT_EQ(lamp->source, table.source);
    }
  }
}

TEST(Illuminants, HaveNamesOfTheirOwnAndTellWhatTheyAre) {
  std::set<std::string> names;
  for (const Illuminant& lamp : illuminants()) {
    EXPECT_TRUE(names.insert(lower(lamp.name)).second) << lamp.name;
    EXPECT_GT(lamp.description.size(), 10u) << lamp.name;
    EXPECT_GT(lamp.source.size(), 10u) << lamp.name;
    EXPECT_TRUE(lamp.note.empty()) << lamp.name;
    for (const double power : lamp.power) EXPECT_GE(power, 0) << lamp.name;
    const auto named = illuminant_named(" " + lower(lamp.name) + " ");
    ASSERT_TRUE(named) << lamp.name;
    EXPECT_EQ(named->name, lamp.name);
  }
  EXPECT_GE(names.size(), 40u);
}

TEST(IlluminantNames, FluorescentLampsHaveAShortForm) {
  EXPECT_EQ(find_illuminant("F11"), find_illuminant("FL11"));
  EXPECT_EQ(find_illuminant("f3.15"), find_illuminant("FL3.15"));
  EXPECT_EQ(find_illuminant("F13"), nullptr);
  EXPECT_EQ(find_illuminant("F"), nullptr);
  EXPECT_EQ(find_illuminant("ED-B1"), nullptr);
}

TEST(IlluminantNames, TemperaturesMakeLamps) {
  for (const char* text : {"blackbody:3000K", "BlackBody: 3000 k", "blackbody:3e3", " blackbody:3000 "}) {
    const auto lamp = illuminant_named(text);
    ASSERT_TRUE(lamp) << text;
    EXPECT_EQ(lamp->name, "blackbody:3000K");
    EXPECT_EQ(lamp->power, blackbody_power(3000));
  }
  const auto day = illuminant_named("daylight:5000.5K");
  ASSERT_TRUE(day);
  EXPECT_EQ(day->name, "daylight:5000.5K");
  EXPECT_EQ(day->power, daylight_power(5000.5));
}

TEST(IlluminantNames, WhatIsWrongIsSaid) {
  const struct {
    const char *text, *message;
  } cases[] = {
      {"D66", "unknown illuminant 'D66'; did you mean 'D65'?"},
      {"LED-B6", "unknown illuminant 'LED-B6'; did you mean 'LED-B1'?"},
      {"candle",
       "unknown illuminant 'candle'; known: D65, A, E, D50, D55, D75, FL1..FL12, FL3.1..FL3.15, LED-B1..LED-B5, "
       "LED-BH1, LED-RGB1, LED-V1..LED-V2, blackbody:3000K (1000..100000 K), daylight:5000K (4000..25000 K)"},
      {"black-body:2856K", "unknown illuminant 'black-body:2856K'; did you mean 'blackbody:3000K'?"},
      {"blackbody", "expected 'blackbody:' and a temperature from 1000 to 100000 K, got ''"},
      {"blackbody:999", "expected 'blackbody:' and a temperature from 1000 to 100000 K, got '999'"},
      {"blackbody:nan", "expected 'blackbody:' and a temperature from 1000 to 100000 K, got 'nan'"},
      {"blackbody:100001K", "expected 'blackbody:' and a temperature from 1000 to 100000 K, got '100001K'"},
      {"daylight:3999K", "expected 'daylight:' and a temperature from 4000 to 25000 K, got '3999K'"},
      {"daylight:25001", "expected 'daylight:' and a temperature from 4000 to 25000 K, got '25001'"},
      {"file:a.csv", "no file can be read here, got 'file:a.csv'"},
  };
  for (const auto& one : cases) {
    const auto lamp = illuminant_named(one.text);
    ASSERT_FALSE(lamp) << one.text;
    EXPECT_EQ(lamp.errors().front().message, one.message);
    EXPECT_EQ(lamp.errors().front().failure, shabon::Failure::content);
  }
  EXPECT_FALSE(illuminant_named(""));
}

TEST(IlluminantNames, FilesAreRecognised) {
  EXPECT_EQ(illuminant_file("file:a b.csv"), "a b.csv");
  EXPECT_EQ(illuminant_file(" FILE:\"a b.csv\" "), "a b.csv");
  EXPECT_EQ(illuminant_file("files"), std::nullopt);
}

// CIE 15:2018, 4.1.1: A is the blackbody of 2848 K with c2 = 1.435e-2 m K, rounded to six digits.
TEST(Blackbody, IsLampAAtItsTemperature) {
  const double kelvin = 2848 * second_radiation_constant_nm_kelvin / 1.435e7;
  EXPECT_NEAR(kelvin, 2855.5, 0.01);
  const Spectrum planck = blackbody_power(kelvin);
  const Illuminant& a = *find_illuminant("A");
  for (std::size_t i = 0; i < planck.size(); ++i) EXPECT_NEAR(planck[i] / a.power[i], 1, 6e-6) << wavelength_nm(i);
}

// CODATA 2018: c2 = 1.438776877e-2 m K exactly to the digits shown; Wien: the peak lies at 2897.771955 um K / T.
TEST(Blackbody, HasTheConstantsOfTheSi) {
  EXPECT_NEAR(second_radiation_constant_nm_kelvin, 1.438776877e7, 0.6e-2);
  const Spectrum power = blackbody_power(2897.771955e3 / 600);
  EXPECT_EQ(wavelength_nm(static_cast<std::size_t>(std::max_element(power.begin(), power.end()) - power.begin())), 600);
  for (const double kelvin : {1000.0, 5000.0, 100'000.0}) EXPECT_DOUBLE_EQ(blackbody_power(kelvin)[200], 100);
}

// The CIE's tables of D50 and D65 against the formula they come from, with the weights rounded as the CIE does.
TEST(Daylight, IsTheTabulatedOne) {
  const struct {
    const char* name;
    double nominal_kelvin;
  } lamps[] = {{"D50", 5000}, {"D65", 6500}};
  for (const auto& lamp : lamps) {
    const double kelvin = lamp.nominal_kelvin * nominal_daylight_scale;
    const Spectrum& table = find_illuminant(lamp.name)->power;
    EXPECT_LT(largest_difference(daylight_power(kelvin, DaylightWeights::three_decimals), table), 1e-3) << lamp.name;
    EXPECT_LT(largest_difference(daylight_power(kelvin), table), 0.02) << lamp.name;
  }
}

// The spectrum has the chromaticity it was made for, and the two branches of the formula meet at 7000 K.
TEST(Daylight, HasItsChromaticity) {
  for (double kelvin = 4000; kelvin <= 25'000; kelvin += 250) {
    const auto lamp = illuminant_named("daylight:" + std::to_string(kelvin));
    ASSERT_TRUE(lamp);
    const Xy wanted = daylight_chromaticity(kelvin), xy = chromaticity(white_point(*lamp));
    EXPECT_NEAR(xy.x, wanted.x, 2e-4) << kelvin;
    EXPECT_NEAR(xy.y, wanted.y, 2e-4) << kelvin;
    for (const double power : lamp->power) EXPECT_GE(power, 0) << kelvin;
    EXPECT_NEAR(lamp->power[200], 100, 1e-9);
  }
  EXPECT_NEAR(daylight_chromaticity(7000).x, daylight_chromaticity(7000 + 1e-9).x, 1e-5);
}

TEST(ColorTemperature, OfABlackbodyIsItsOwn) {
  for (const double kelvin : {1001.0, 1500.0, 2856.0, 5000.0, 6504.0, 20'000.0, 99'000.0}) {
    const auto found = correlated_color_temperature(chromaticity(radiance_to_xyz(blackbody_power(kelvin))));
    ASSERT_TRUE(found) << kelvin;
    EXPECT_NEAR(found->kelvin / kelvin, 1, 1e-7);
    EXPECT_NEAR(found->duv, 0, 1e-10);
  }
}

// Daylight lies on the green side of the blackbodies, the equal-energy lamp on the other.
TEST(ColorTemperature, MeasuresTheDistanceFromTheLocus) {
  const auto green = correlated_color_temperature({0.3127, 0.3290}),
             violet = correlated_color_temperature({1 / 3.0, 1 / 3.0});
  ASSERT_TRUE(green && violet);
  EXPECT_NEAR(green->duv, 0.0032, 1e-4);    // D65 lies above the blackbodies
  EXPECT_NEAR(violet->duv, -0.0044, 1e-4);  // E below
  EXPECT_NEAR(violet->kelvin, 5455, 2);
}

TEST(ColorTemperature, IsNotGivenToColours) {
  for (const Xy xy : {Xy{0.64, 0.33}, Xy{0.3, 0.6}, Xy{0.15, 0.06}, Xy{0, 0}, Xy{NAN, 0.3}})
    EXPECT_FALSE(correlated_color_temperature(xy)) << xy.x;
  // Beyond both ends of the range.
  EXPECT_FALSE(correlated_color_temperature(chromaticity(radiance_to_xyz(blackbody_power(950)))));
  EXPECT_FALSE(correlated_color_temperature(chromaticity(radiance_to_xyz(blackbody_power(130'000)))));
}

TEST(LampFromSamples, IsLinearBetweenAndZeroBeyond) {
  const std::vector<double> nm{400, 450.5, 700}, power{2, 4, 0};
  const auto lamp = illuminant_from_samples("mine", "measured", nm, power);
  ASSERT_TRUE(lamp);
  EXPECT_EQ(lamp->power[39], 0);
  EXPECT_EQ(lamp->power[341], 0);
  const double scale = lamp->power[40] / 2;
  EXPECT_NEAR(lamp->power[65], scale * (2 + 2 * 25 / 50.5), 1e-12);
  EXPECT_NEAR(lamp->power[240], scale * 4 * 100 / 249.5, 1e-12);
  EXPECT_EQ(lamp->note, "lamp 'mine' is given for 400..700 nm and taken as zero in the rest of 360..830 nm");
}

TEST(LampFromSamples, OfTheWholeRangeIsThatLamp) {
  const Illuminant& d65 = *find_illuminant("D65");
  std::vector<double> nm, power;
  for (std::size_t i = 0; i < d65.power.size(); ++i) {
    nm.push_back(wavelength_nm(i));
    power.push_back(d65.power[i] * 1e-30);
  }
  const auto lamp = illuminant_from_samples("copy", "", nm, power);
  ASSERT_TRUE(lamp);
  EXPECT_TRUE(lamp->note.empty());
  const Xyz white = white_point(*lamp), expected = white_point(d65);
  EXPECT_NEAR(white.x, expected.x, 1e-12);
  EXPECT_NEAR(white.z, expected.z, 1e-12);
}

TEST(LampFromSamples, RefusesWhatIsNoLamp) {
  using List = std::vector<double>;
  const auto refused = [](const List& nm, const List& power) { return !illuminant_from_samples("x", "", nm, power); };
  EXPECT_TRUE(refused({}, {}));
  EXPECT_TRUE(refused({500}, {1}));
  EXPECT_TRUE(refused({500, 600}, {1}));
  EXPECT_TRUE(refused({500, 500}, {1, 1}));
  EXPECT_TRUE(refused({600, 500}, {1, 1}));
  EXPECT_TRUE(refused({0, 500}, {1, 1}));
  EXPECT_TRUE(refused({400, 500}, {1, -1}));
  EXPECT_TRUE(refused({400, NAN}, {1, 1}));
  EXPECT_TRUE(refused({400, 500}, {1, INFINITY}));
  EXPECT_TRUE(refused({400, 500}, {0, 0}));
  EXPECT_TRUE(refused({900, 1000}, {1, 1}));
  EXPECT_FALSE(refused({400, 500}, {0, 1}));
}

}  // namespace
