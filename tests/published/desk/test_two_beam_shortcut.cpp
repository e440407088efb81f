// The shortcut of two beams against an independent program: the corrected two-beam model of a free film, n = 4/3, under
// D65 (the head of the file names versions and conventions).
#include <gtest/gtest.h>

#include <map>

#include "shabon/color/rgb.h"
#include "shabon/desk/comparison.h"
#include "shabon/io/csv.h"

namespace shabon::desk {
namespace {

constexpr double tolerance = 1e-10;

TEST(TwoBeamShortcut, AgreesWithAnIndependentProgram) {
  const Result<io::CsvTable> table = io::read_csv(SHABON_TEST_DATA "/color/two_beam_newton_d65.csv");
  ASSERT_TRUE(table.ok());
  const auto column = [&](std::string_view name) { return *io::numbers(*table, name); };
  const auto d = column("d_nm"), theta = column("theta_deg"), x = column("X"), y = column("Y"), z = column("Z");
  const auto r = column("linDR"), g = column("linDG"), b = column("linDB");
  const Shortcut* two_beam = find_shortcut("two-beam");
  ASSERT_NE(two_beam, nullptr);
  for (std::size_t i = 0; i < d.size(); ++i) {
    SCOPED_TRACE(testing::Message() << d[i] << " nm at " << theta[i] << " degrees");
    Sweep film{{optics::Medium(), {{optics::Medium::constant(4.0 / 3), 0, true}}, optics::Medium()}, 0, {d[i]}};
    film.incidence = optics::incidence_from(Degrees(theta[i]));
    const std::vector<color::Xyz> colors = two_beam->colors(film, color::illuminants()[0], color::observer_1931());
    ASSERT_EQ(colors.size(), 1u);
    EXPECT_NEAR(colors[0].x, x[i], tolerance);
    EXPECT_NEAR(colors[0].y, y[i], tolerance);
    EXPECT_NEAR(colors[0].z, z[i], tolerance);
    const color::LinearRgb linear = color::xyz_to_linear_srgb(colors[0]);
    EXPECT_NEAR(linear.r, r[i], tolerance);
    EXPECT_NEAR(linear.g, g[i], tolerance);
    EXPECT_NEAR(linear.b, b[i], tolerance);
  }
}

}  // namespace
}  // namespace shabon::desk
