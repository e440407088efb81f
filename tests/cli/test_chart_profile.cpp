// chart profile: thickness and colour from the top of a bubble to its bottom.
#include <gtest/gtest.h>

#include <cmath>

#include "../well_formed_xml.h"
#include "chart_calls.h"
#include "printed.h"
#include "shabon/api/resolvers.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/film/thickness_field.h"
#include "shabon/io/image.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::test {
namespace {

io::CsvTable profile_of(const std::string& model, const Arguments& more = {}) {
  return table_of(Arguments{"chart", "profile", "--model", model, "--format", "csv"} + more);
}

// A model of every kind, as a file states it and as it is: one more kind asks for one more line.
const std::vector<std::pair<std::string, film::ThicknessModel>> models = {
    {"constant_nm: 500", film::ConstantThickness{500}},
    {"linear: {top_nm: 200, bottom_nm: 700}", film::LinearThickness{200, 700}},
    {"equilibrium: {mean_nm: 500, squeeze: 0.9}", film::EquilibriumThickness{.mean_nm = 500, .squeeze = 0.9}},
    {"rigid_drainage: {start_nm: 1000, age_s: 40000}", film::RigidDrainageThickness{.start_nm = 1000, .age_s = 40000}},
    {"self_similar: {top_nm: 300, bottom_nm: 1600}", film::SelfSimilarThickness{.top_nm = 300, .bottom_nm = 1600}},
    {"noise: {base: {constant_nm: 400}, seed: 5}",
     film::NoiseThickness{.base = Indirect<film::BaseThickness>({film::ConstantThickness{400}}), .seed = 5}},
};

TEST(ChartProfile, FollowsEveryModel) {
  ASSERT_EQ(models.size(), std::variant_size_v<film::ThicknessModel>);
  for (std::size_t m = 0; m < models.size(); ++m) {
    const auto& [text, model] = models[m];
    ASSERT_EQ(model.index(), m);
    const io::CsvTable table = profile_of(text, {"--time", "0,7.5"});
    const auto time_s = column(table, "time_s"), height = column(table, "height"), nm = column(table, "thickness_nm");
    const auto polar_deg = column(table, "polar_angle_deg"), least = column(table, "least_nm"),
               mean = column(table, "mean_nm"), largest = column(table, "largest_nm");
    ASSERT_EQ(nm.size(), 2u * 1001);
    EXPECT_EQ(height.front(), 1);
    EXPECT_EQ(height.back(), -1);
    const film::ThicknessField fields[] = {film::at_time(model, 0), film::at_time(model, 7.5)};
    bool varies = false;
    for (std::size_t i = 0; i < nm.size(); ++i) {
      EXPECT_NEAR(std::cos(polar_deg[i] * std::acos(-1) / 180), height[i], 1e-12);
      const math::Vec3d at{0, height[i], std::sqrt(1 - height[i] * height[i])};
      ASSERT_NEAR(nm[i], film::thickness_nm(fields[time_s[i] == 0 ? 0 : 1], at), 1e-6 * nm[i]) << text << i;
      EXPECT_TRUE(least[i] <= nm[i] && nm[i] <= largest[i] && least[i] <= mean[i] && mean[i] <= largest[i]) << text;
      varies |= largest[i] > 1.01 * least[i];
    }
    EXPECT_EQ(varies, std::holds_alternative<film::NoiseThickness>(model)) << text;
  }
}

TEST(ChartProfile, IsStraightInHeightAsThePaperSays) {
  const io::CsvTable table = table_of({"chart", "profile", "--format", "csv"});
  const auto height = column(table, "height"), nm = column(table, "thickness_nm");
  for (std::size_t i = 0; i < nm.size(); ++i) EXPECT_NEAR(nm[i], 525 - 375 * height[i], 1e-9);
}

// The colours are those of the stack with that thickness, for a layer of several and at an angle.
TEST(ChartProfile, HoldsTheColoursOfTheReference) {
  const io::CsvTable table =
      table_of({"chart", "profile", "air | MgF2 100nm | 2.3 0nm | glass", "--layer", "2", "--angle", "40", "--side",
                "transmitted", "--time", "0,9", "--model", models[4].first, "--format", "csv"});
  const auto nm = column(table, "thickness_nm"), X = column(table, "X"), Y = column(table, "Y");
  for (std::size_t i = 0; i < nm.size(); i += 200) {
    const auto stack =
        optics::parse_stack("air | MgF2 100nm | 2.3 " + format_exact(nm[i]) + "nm | glass", api::medium_resolver());
    ASSERT_TRUE(stack);
    const color::Xyz exact =
        color::reflectance_to_xyz(desk::unpolarised(*stack, optics::Interference::airy,
                                                    optics::incidence_from(Degrees(40)), desk::Side::transmitted),
                                  color::illuminants()[0]);
    EXPECT_NEAR(X[i], exact.x, 1e-9) << i;
    EXPECT_NEAR(Y[i], exact.y, 1e-9) << i;
  }
}

// Four columns and two rows of 200 to 800 nm: what lies around the top is the upper row, and +z is where the last
// column meets the first.
TEST(ChartProfile, ReadsMaps) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> rgb;
  for (const int value : {51, 102, 102, 51, 204, 204, 153, 153})
    rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(value));
  folder.write("film.png", *io::encode_png(4, 2, rgb, {}));
  const Outcome outcome = run(
      {"chart", "profile", "--model", "map: {file: film.png, low_nm: 0, high_nm: 1000}", "-o", "a.csv", "-o", "a.svg"},
      in(folder));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Result<io::CsvTable> table = io::read_csv(folder.path() / "a.csv");
  ASSERT_TRUE(table);
  const auto nm = column(*table, "thickness_nm"), least = column(*table, "least_nm"), mean = column(*table, "mean_nm"),
             largest = column(*table, "largest_nm");
  EXPECT_NEAR(nm[10], 200, 1e-3);
  EXPECT_NEAR(least[10], 200, 1e-3);
  EXPECT_NEAR(mean[10], 300, 1);
  EXPECT_NEAR(largest[10], 400, 1e-3);
  EXPECT_NEAR(nm[990], 700, 1e-3);
  EXPECT_NEAR(mean[990], 700, 1);
  const std::string svg = read_all(folder.path() / "a.svg");
  EXPECT_NE(svg.find("Dashed: least and largest"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
}

// Films at several times are drawn with one factor, so that the thin one looks as dark as it is.
TEST(ChartProfile, OneBrightnessForAllTimes) {
  const auto factors = [](const Arguments& more) {
    return column(profile_of("self_similar: {top_nm: 100, bottom_nm: 120}", Arguments{"--time", "0,90"} + more),
                  "display_factor");
  };
  EXPECT_EQ(factors({}).front(), factors({}).back());
  EXPECT_LT(factors({"--exposure", "each"}).front(), 0.5 * factors({"--exposure", "each"}).back());
}

// The orders lie along the strip where the film has their thickness: 550/(2 n) nm each.
TEST(ChartProfile, MarksTheOrders) {
  const auto orders = [](const std::string& model) {
    const std::string svg =
        result_of({"chart", "profile", "air | 1.375 0nm | air", "--model", model, "--format", "svg"});
    return std::pair(count(svg, " order</text>"), svg.find("Orders:") != std::string::npos);
  };
  EXPECT_EQ(orders("linear: {top_nm: 0, bottom_nm: 799}"), std::pair(std::size_t{4}, true));
  EXPECT_EQ(orders("constant_nm: 300"), std::pair(std::size_t{1}, true));
  EXPECT_EQ(orders("noise: {base: {constant_nm: 400}, amplitude: 0.4, octaves: 7, roughness: 1}").second, false);
}

}  // namespace
}  // namespace shabon::test
