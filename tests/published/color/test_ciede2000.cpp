// The 34 published pairs of Sharma, Wu and Dalal (2005), to the four decimals printed.
#include <gtest/gtest.h>

#include "read_csv.h"
#include "shabon/color/lab.h"

namespace {

using namespace shabon::color;

TEST(Ciede2000, PublishedPairs) {
  constexpr double printed = 0.5e-4 + 1e-9;
  const auto rows = read_csv("color/ciede2000_sharma_34.csv");
  ASSERT_EQ(rows.size(), 34u);
  for (const CsvRow& row : rows) {
    const Lab first{row.at("L1"), row.at("a1"), row.at("b1")}, second{row.at("L2"), row.at("a2"), row.at("b2")};
    EXPECT_NEAR(ciede2000(first, second), row.at("dE00_published"), printed) << "pair " << row.at("pair");
    EXPECT_NEAR(ciede2000(second, first), row.at("dE00_published"), printed) << "pair " << row.at("pair") << " swapped";
  }
}

// Two independent codes to twelve digits, away from pair 14: there rounding sends them to the other branch.
TEST(Ciede2000, IndependentCodes) {
  for (const CsvRow& row : read_csv("color/ciede2000_sharma_34.csv")) {
    if (row.at("pair") == 14) continue;
    const Lab first{row.at("L1"), row.at("a1"), row.at("b1")}, second{row.at("L2"), row.at("a2"), row.at("b2")};
    EXPECT_NEAR(ciede2000(first, second), row.at("dE00_colour"), 1e-11) << "pair " << row.at("pair");
    EXPECT_NEAR(ciede2000(first, second), row.at("dE00_luxpy"), 1e-11) << "pair " << row.at("pair");
  }
}

}  // namespace
