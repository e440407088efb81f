// Every medium of the library against the values of its source: tests/data/optics/nk/index.csv names them one by one.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "shabon/optics/media.h"
#include "vectors.h"

namespace shabon::optics {
namespace {

constexpr double check_digits = 6e-7;  // check values have six decimals

// The lines F, D (the mean of the doublet) and C, as the check values were taken.
constexpr double sodium_D_nm = 589.2937;
const std::pair<const char*, double> lines[] = {
    {"n_486.13", 486.1327}, {"n_589.29", sodium_D_nm}, {"n_656.27", 656.2725}};

// A medium without a row, or a row without a medium, has been forgotten.
TEST(MediaValues, EveryMediumHasItsCheckValues) {
  const VectorFile index("nk/index.csv");
  std::set<std::string> rows, media;
  for (const VectorRow& row : index.rows) EXPECT_TRUE(rows.insert(row.text("medium")).second) << row.text("medium");
  for (const MediumEntry& entry : media_library()) media.insert(std::string(entry.name));
  EXPECT_EQ(rows, media);
}

TEST(MediaValues, AtTheFraunhoferLines) {
  const VectorFile index("nk/index.csv");
  for (const VectorRow& row : index.rows) {
    const auto medium = find_medium(row.text("medium"));
    ASSERT_TRUE(medium) << row.text("medium");
    for (const auto& [column, wavelength_nm] : lines)
      EXPECT_NEAR(medium->index(wavelength_nm).real(), row.number(column), check_digits)
          << row.text("medium") << " " << column;
    EXPECT_NEAR(medium->index(sodium_D_nm).imag(), row.number("k_589.29"), check_digits) << row.text("medium");
  }
}

TEST(MediaValues, FollowTheirSources) {
  const VectorFile index("nk/index.csv");
  int tables = 0;
  for (const VectorRow& row : index.rows) {
    if (row.text("table").empty()) continue;
    ++tables;
    const Medium medium = find_medium(row.text("medium")).value();
    const WavelengthRange range = medium.range_nm().value();
    const VectorFile table("nk/" + row.text("table"));
    ASSERT_GT(table.rows.size(), 15u) << row.text("table");
    int covered = 0;
    for (const VectorRow& sample : table.rows) {
      const double nm = sample.number("lambda_nm");
      covered += medium.covers(nm);
      EXPECT_NEAR(medium.index(nm).real(), sample.number("n"), 1e-12) << medium.name() << " at " << nm;
      // Rows beyond a table of k are not told apart by the sampled file.
      if (nm > range.last_nm) continue;
      EXPECT_NEAR(medium.index(nm).imag(), sample.number("k"), 1e-12) << medium.name() << " at " << nm;
    }
    EXPECT_GE(covered, static_cast<int>(table.rows.size()) * 9 / 10) << medium.name();
  }
  EXPECT_GT(tables, 30);
}

// Two independent formulas for water at 20 C, Daimon and Masumura against the release of the IAPWS.
TEST(MediaValues, WaterAgreesWithTheIapws) {
  const Medium water = find_medium("water").value();
  for (const VectorRow& row : VectorFile("nk/water_iapws_r9-97_20C.csv").rows) {
    const double nm = row.number("lambda_nm");
    if (nm < rendered_range_nm.first_nm || nm > rendered_range_nm.last_nm) continue;
    EXPECT_NEAR(water.index(nm).real(), row.number("n"), 6e-5) << nm;
  }
}

// The density of the two liquids, g/cm^3 at 20 C, turns shares of the weight into shares of the volume.
double volume_share(double weight_share) {
  constexpr double glycerol_density = 1.2611, water_density = 0.9982;
  const double glycerol = weight_share / glycerol_density;
  return glycerol / (glycerol + (1 - weight_share) / water_density);
}

// L. F. Hoyt, New table of the refractive index of pure glycerol at 20 C, Ind. Eng. Chem. 26, 329-332 (1934). The rule
// knows nothing of the 1 % of the volume that vanishes when water and glycerol are mixed.
TEST(MediaValues, MixingRuleComesNearWaterAndGlycerol) {
  struct Row {
    double weight_share, n_D;
  };
  const Row rows[] = {{0.0, 1.33303}, {0.2, 1.35749}, {0.4, 1.38413}, {0.6, 1.41299}, {0.8, 1.44290}, {1.0, 1.47399}};
  const Medium water = find_medium("water").value(), glycerol = find_medium("glycerol").value();
  for (const Row& row : rows) {
    const double share = volume_share(row.weight_share);
    const Medium mixture = Medium::mixture({{water, 1 - share}, {glycerol, share}}, {}).value();
    EXPECT_NEAR(mixture.index(589.3).real(), row.n_D, 6e-3) << row.weight_share;
  }
}

}  // namespace
}  // namespace shabon::optics
