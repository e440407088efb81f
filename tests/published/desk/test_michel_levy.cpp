// Colours between crossed polarisers against colour-science 0.4.6 (the head of the file names versions and
// conventions).
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/color/rgb.h"
#include "shabon/desk/retardation.h"
#include "shabon/io/csv.h"

namespace shabon::desk {
namespace {

constexpr double tolerance = 1e-9;

const color::Illuminant& d65() { return color::illuminants()[0]; }

TEST(MichelLevy, AgreesWithAnIndependentProgram) {
  const Result<io::CsvTable> table = io::read_csv(SHABON_TEST_DATA "/color/michel_levy_d65.csv");
  ASSERT_TRUE(table.ok());
  const auto column = [&](std::string_view name) { return *io::numbers(*table, name); };
  const std::vector<double> retardations_nm = column("retardation_nm");
  ASSERT_GT(retardations_nm.size(), 50u);
  const std::vector<color::Xyz> colors = retardation_colors(retardations_nm, d65());
  ASSERT_EQ(colors.size(), retardations_nm.size());
  const auto x = column("X"), y = column("Y"), z = column("Z");
  const auto r = column("linDR"), g = column("linDG"), b = column("linDB");
  for (std::size_t i = 0; i < colors.size(); ++i) {
    SCOPED_TRACE(testing::Message() << retardations_nm[i] << " nm");
    EXPECT_NEAR(colors[i].x, x[i], tolerance);
    EXPECT_NEAR(colors[i].y, y[i], tolerance);
    EXPECT_NEAR(colors[i].z, z[i], tolerance);
    const color::LinearRgb linear = color::xyz_to_linear_srgb(colors[i]);
    EXPECT_NEAR(linear.r, r[i], tolerance);
    EXPECT_NEAR(linear.g, g[i], tolerance);
    EXPECT_NEAR(linear.b, b[i], tolerance);
  }
}

// Dark for whole waves, open for half ones, the same for either sign.
TEST(MichelLevy, KnowsWholeAndHalfWaves) {
  for (const int wavelength_nm : {400, 550, 700})
    for (const int order : {0, 1, 7, 1000}) {
      const auto share = [&](double retardation_nm) {
        return crossed_polars_share(retardation_nm)[static_cast<std::size_t>(wavelength_nm - color::first_nm)];
      };
      EXPECT_EQ(share(order * wavelength_nm), 0);
      EXPECT_NEAR(share((order + 0.5) * wavelength_nm), 1, 1e-15);
      EXPECT_NEAR(share((order + 0.25) * wavelength_nm), 0.5, 1e-9);
      EXPECT_EQ(share((order + 0.3) * wavelength_nm), share(-(order + 0.3) * wavelength_nm));
    }
  // Quartz (0.009) in a thin section of 30 um: the white at the end of the first order's greys.
  EXPECT_NEAR(retardation_nm(0.009, 30'000), 270, 1e-10);
}

}  // namespace
}  // namespace shabon::desk
