// Water by Daimon's formula against its tabulated values.
#include <gtest/gtest.h>

#include "shabon/optics/media.h"
#include "vectors.h"

namespace shabon::optics {
namespace {

TEST(WaterIndex, FollowsDaimon) {
  const VectorFile file("water_daimon_20C.csv");
  const Medium water = find_medium("water").value();
  ASSERT_GT(file.rows.size(), 100u);
  for (const VectorRow& row : file.rows) {
    const double lambda_nm = row.number("lambda_nm");
    EXPECT_NEAR(water.index(lambda_nm).real(), row.number("n"), 1e-12) << lambda_nm;
    EXPECT_EQ(water.index(lambda_nm).imag(), 0) << lambda_nm;
  }
}

// The F, D and C lines, evaluated from the same formula by an independent reader of refractiveindex.info.
TEST(WaterIndex, AtTheFraunhoferLines) {
  const Medium water = find_medium("water").value();
  EXPECT_NEAR(water.index(486.13).real(), 1.337492, 5e-7);
  EXPECT_NEAR(water.index(589.29).real(), 1.333349, 5e-7);
  EXPECT_NEAR(water.index(656.27).real(), 1.331513, 5e-7);
}

}  // namespace
}  // namespace shabon::optics
