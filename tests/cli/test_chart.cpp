// chart: what it draws, and the numbers beside the drawing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "../well_formed_xml.h"
#include "chart_calls.h"
#include "printed.h"
#include "shabon/api/resolvers.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/io/image.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::test {
namespace {

std::vector<std::string> texts(const io::CsvTable& table, std::string_view name) {
  std::vector<std::string> cells;
  for (const io::CsvRow& row : table.rows) cells.push_back(row.cells[*table.column(name)].text);
  return cells;
}

TEST(Chart, EveryKindIsWrittenInEveryForm) {
  ASSERT_EQ(kinds(), (std::vector<std::string>{"newton", "angle", "michel-levy", "profile"}));
  for (const std::string& kind : kinds()) {
    const TemporaryFolder folder;
    const Outcome outcome = run(quick(kind) + Arguments{"-o", "a.png", "-o", "b.SVG", "-o", "c.csv"}, in(folder));
    EXPECT_EQ(outcome.exit_code, 0) << kind << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"a.png", "b.SVG", "c.csv"})) << kind;
    const Result<io::Rgb8Image> png = io::read_png(folder.path() / "a.png");
    ASSERT_TRUE(png) << kind;
    EXPECT_EQ(png->width, 600);
    EXPECT_NE(read_all(folder.path() / "a.png").find("sRGB"), std::string::npos);
    EXPECT_NE(read_all(folder.path() / "a.png").find("pHYs"), std::string::npos);
    const std::string svg = read_all(folder.path() / "b.SVG");
    EXPECT_TRUE(is_well_formed(svg)) << kind;
    EXPECT_NE(svg.find("(nm)"), std::string::npos) << kind;
    EXPECT_EQ(svg.find("\"nan"), std::string::npos) << kind;
    EXPECT_TRUE(io::read_csv(folder.path() / "c.csv")) << kind;
    EXPECT_EQ(read_all(folder.path() / "c.csv"), result_of(quick(kind) + Arguments{"--format", "csv"}));
    EXPECT_EQ(svg, result_of(quick(kind) + Arguments{"--format", "svg"}));
  }
}

TEST(Chart, IsCalledAfterItsKind) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(quick("newton"), in(folder)).exit_code, 0);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"newton.png"});
}

TEST(Chart, SameInputSameBits) {
  for (const std::string& kind : kinds()) {
    const Arguments png = quick(kind) + Arguments{"--format", "png"};
    EXPECT_EQ(result_of(png), result_of(png)) << kind;
  }
}

// The rows of newton and angle against the reference.
void expect_film_colors(const Arguments& arguments, const std::string& stack_head, const std::string& stack_tail) {
  const io::CsvTable table = table_of(arguments);
  const auto angle_deg = column(table, "angle_deg"), thickness_nm = column(table, "thickness_nm");
  const auto X = column(table, "X"), Y = column(table, "Y"), Z = column(table, "Z");
  const std::vector<std::string> sides = texts(table, "side");
  ASSERT_GT(X.size(), 10u);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const auto stack =
        optics::parse_stack(stack_head + format_number(thickness_nm[i]) + "nm" + stack_tail, api::medium_resolver());
    ASSERT_TRUE(stack);
    const color::Xyz exact = color::reflectance_to_xyz(
        desk::unpolarised(*stack, optics::Interference::airy, optics::incidence_from(Degrees(angle_deg[i])),
                          sides[i] == "reflected" ? desk::Side::reflected : desk::Side::transmitted),
        color::illuminants()[0]);
    EXPECT_NEAR(X[i], exact.x, 1e-10) << i;
    EXPECT_NEAR(Y[i], exact.y, 1e-10) << i;
    EXPECT_NEAR(Z[i], exact.z, 1e-10) << i;
  }
}

TEST(Chart, NewtonHoldsTheColoursOfTheReference) {
  const Arguments csv = {"--format", "csv"};
  expect_film_colors(Arguments{"chart", "newton", "--thickness", "0:900nm:100nm", "--angle", "0,30,85"} + csv,
                     "air | water ", " | air");
  expect_film_colors(Arguments{"chart", "newton", "air | MgF2 100nm | 2.3 0nm | glass", "--layer", "2", "--thickness",
                               "0:0.4um:100nm", "--side", "both", "--angle", "0:60:30"} +
                         csv,
                     "air | MgF2 100nm | 2.3 ", " | glass");
}

TEST(Chart, AngleHoldsTheColoursOfTheReference) {
  expect_film_colors({"chart", "angle", "air | SiO2 0nm | Si", "--thickness", "0:400nm:100nm", "--angle", "0:90:15",
                      "--format", "csv"},
                     "air | SiO2 ", " | Si");
  expect_film_colors({"chart", "angle", "air | TiO2 0nm | glass", "--thickness", "0:400nm:100nm", "--angle", "0:90:15",
                      "--side", "both", "--format", "csv"},
                     "air | TiO2 ", " | glass");
  const io::CsvTable table = table_of(quick("angle") + Arguments{"--format", "csv"});
  EXPECT_EQ(table.rows.size(), 11u * 5u);
  const std::vector<std::string> sides = texts(table, "side");
  EXPECT_EQ(std::set<std::string>(sides.begin(), sides.end()), std::set<std::string>{"reflected"});
}

// Colours computed by colour-science; the file says how.
TEST(Chart, MichelLevyAgreesWithAnIndependentProgram) {
  const Result<io::CsvTable> known = io::read_csv(SHABON_TEST_DATA "/color/michel_levy_d65.csv");
  ASSERT_TRUE(known);
  const std::vector<double> at = column(*known, "retardation_nm");
  const std::string range =
      format_number(at.front()) + ":" + format_number(at.back()) + ":" + format_number(at[1] - at[0]);
  const io::CsvTable table = table_of({"chart", "michel-levy", "--retardation", range, "--format", "csv"});
  EXPECT_EQ(column(table, "retardation_nm"), at);
  for (const auto& [ours, theirs] : std::map<std::string, std::string>{
           {"X", "X"}, {"Y", "Y"}, {"Z", "Z"}, {"linear_r", "linDR"}, {"linear_g", "linDG"}, {"linear_b", "linDB"}}) {
    const std::vector<double> a = column(table, ours), b = column(*known, theirs);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << ours << " " << at[i];
  }
  const std::vector<double> order = column(table, "order");
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_EQ(order[i], std::floor(at[i] / 550) + 1);
}

using Pixel = std::tuple<int, int, int>;

Pixel pixel(const io::Rgb8Image& image, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

Pixel pixel(const std::string& hex) {
  const auto part = [&](std::size_t at) { return std::stoi(hex.substr(at, 2), nullptr, 16); };
  return {part(1), part(3), part(5)};
}

// Some row of pixels shows all colours of the table, unsmoothed and in their order.
TEST(Chart, ThePictureShowsTheColoursOfTheTable) {
  for (const Arguments& arguments :
       {quick("newton") + Arguments{"--side", "reflected"},
        {"chart", "michel-levy", "--retardation", "0:1800nm:20nm", "--birefringence", "0.3"},
        Arguments{"chart", "profile"}}) {
    const TemporaryFolder folder;
    EXPECT_EQ(run(arguments + Arguments{"-o", "a.png", "-o", "a.csv"}, in(folder)).exit_code, 0);
    const Result<io::Rgb8Image> png = io::read_png(folder.path() / "a.png");
    const Result<io::CsvTable> table = io::read_csv(folder.path() / "a.csv");
    ASSERT_TRUE(png && table);
    std::vector<std::string> hex = texts(*table, "hex");
    if (arguments[1] == "profile") hex = {hex.begin() + 1, hex.end() - 1};  // the ends are under the strip's rim
    std::size_t most = 0;
    for (int y = 0; y < png->height; ++y) {
      std::size_t found = 0;
      for (int x = 0; x < png->width && found < hex.size(); ++x)
        while (found < hex.size() && pixel(*png, x, y) == pixel(hex[found])) ++found;
      most = std::max(most, found);
    }
    EXPECT_EQ(most, hex.size()) << arguments[1];
  }
}

TEST(Chart, ExposureBrightensTheDrawingAlone) {
  const auto table = [](const std::string& exposure) {
    return table_of({"chart", "newton", "--thickness", "0:600nm:20nm", "--angle", "0,60", "--side", "reflected",
                     "--exposure", exposure, "--format", "csv"});
  };
  const auto brightest = [](const io::CsvTable& csv) {
    std::map<double, double> largest;  // by angle
    const auto angle_deg = column(csv, "angle_deg"), Y = column(csv, "Y"), factor = column(csv, "display_factor");
    for (std::size_t i = 0; i < Y.size(); ++i)
      largest[angle_deg[i]] = std::max(largest[angle_deg[i]], Y[i] * factor[i]);
    return largest;
  };
  const io::CsvTable each = table("each"), one = table("one"), plain = table("0"), brighter = table("1.5");
  EXPECT_NEAR(brightest(each)[0], 1, 1e-12);
  EXPECT_NEAR(brightest(each)[60], 1, 1e-12);
  EXPECT_LT(brightest(one)[0], 0.5);
  EXPECT_NEAR(brightest(one)[60], 1, 1e-12);
  EXPECT_EQ(column(plain, "display_factor").front(), 1);
  EXPECT_EQ(column(brighter, "display_factor").front(), std::exp2(1.5));
  for (const char* name : {"X", "Y", "Z", "linear_r", "linear_g", "linear_b"})
    EXPECT_EQ(column(each, name), column(plain, name));
}

// The lamp itself, through a film of no thickness.
TEST(Chart, AdaptationMakesTheLampWhite) {
  const auto lamp = [](const std::string& adaptation) {
    return texts(table_of({"chart", "newton", "--thickness", "0:100nm:100nm", "--side", "transmitted", "--illuminant",
                           "A", "--exposure", "0", "--gamut", "clip", "--adaptation", adaptation, "--format", "csv"}),
                 "hex")
        .front();
  };
  EXPECT_EQ(lamp("bradford"), "#ffffff");
  EXPECT_NE(lamp("none"), "#ffffff");
}

TEST(Chart, SaysWhatIsDrawn) {
  const std::string newton = result_of({"chart", "newton", "--thickness", "0:2um:5nm", "--curves", "--format", "svg"});
  for (const char* part : {"thickness d of the film: water (nm)", "1st order", "2nd order", "3rd order", "9th order",
                           "air | water d | air", "D65", "reflected at 0", "transmitted at 0", "linear sRGB"})
    EXPECT_NE(newton.find(part), std::string::npos) << part;
  const std::string angle = result_of(quick("angle") + Arguments{"--format", "svg"});
  for (const char* part : {"angle of incidence (degrees)", "thickness d of the film: water (nm)", "reflected light"})
    EXPECT_NE(angle.find(part), std::string::npos) << part;
  const std::string profile = result_of({"chart", "profile", "--time", "0,4", "--format", "svg"});
  for (const char* part : {"thickness d (nm)", "depth below the top", "reflected after 4 s", "1st order", "5th order",
                           "top_nm: 150", "air | water d | air"})
    EXPECT_NE(profile.find(part), std::string::npos) << part;
  const std::string levy = result_of({"chart", "michel-levy", "--format", "svg"});
  for (const char* part : {"retardation (nm)", "thickness (\u00B5m)", "birefringence", ">0.001<", ">0.010<", ">0.050<",
                           ">0.300<", "thin section, 30 \u00B5m", "1st order", "4th order"})
    EXPECT_NE(levy.find(part), std::string::npos) << part;
  const std::string quartz = result_of(quick("michel-levy") + Arguments{"--birefringence", "0.009", "--format", "svg"});
  EXPECT_NE(quartz.find(">0.009<"), std::string::npos);
  EXPECT_EQ(quartz.find(">0.010<"), std::string::npos);
}

// What enters a metal is seen by nobody; it is shown where it is asked for, and said.
TEST(Chart, LightThatEntersAnAbsorbingMediumIsNotShownUnasked) {
  const Arguments oxide = {"chart", "newton", "air | TiO2 0nm | Ti", "--thickness", "0:100nm:50nm", "--format", "csv"};
  const Outcome usual = run(oxide), both = run(oxide + Arguments{"--side", "both"});
  EXPECT_EQ(usual.exit_code, 0);
  EXPECT_EQ(usual.out.find("transmitted,"), std::string::npos);
  EXPECT_NE(usual.out.find("# Reflected light only: Ti absorbs"), std::string::npos) << usual.out;
  EXPECT_NE(usual.err.find("Reflected light only: Ti absorbs"), std::string::npos) << usual.err;
  EXPECT_NE(both.out.find("transmitted,"), std::string::npos);
  EXPECT_NE(both.err.find("Ti absorbs: transmitted is the light that enters it"), std::string::npos) << both.err;
  // Glass, whose k is 1e-8, is as good as clear.
  EXPECT_NE(result_of({"chart", "newton", "air | MgF2 0nm | glass", "--format", "csv"}).find("transmitted,"),
            std::string::npos);
}

TEST(Chart, WithoutInterferenceThereAreNoOrders) {
  for (const Arguments& film :
       {Arguments{"air | glass 1mm incoherent | air"}, Arguments{"air | water 0nm | air", "--interference", "none"}}) {
    const std::string svg = result_of(Arguments{"chart", "newton"} + film + Arguments{"--format", "svg"});
    EXPECT_EQ(svg.find("order"), std::string::npos);
    EXPECT_EQ(svg.find("Orders:"), std::string::npos);
    const std::string map = result_of(Arguments{"chart", "angle"} + film +
                                      Arguments{"--curves", "--thickness", "0:500nm:50nm", "--format", "svg"});
    EXPECT_EQ(map.find("Lines:"), std::string::npos);
  }
}

// A colour of a chart is that of `color`, whose default it shares.
TEST(Chart, DrawsWhatColorTells) {
  const io::CsvTable chart =
      table_of({"chart", "newton", "--thickness", "100:300nm:100nm", "--exposure", "0", "--format", "csv"});
  const io::YamlDocument color = json_of({"color", "air | water 200nm | air", "--format", "json"});
  EXPECT_EQ(texts(chart, "hex")[1], io::find(color.root, "hex_mapped")->text);
}

// Films whose fringes are finer than 1 nm of wavelength have the colours of incoherent ones.
TEST(Chart, VeryThickFilmsAreNotAliased) {
  const auto thick = column(
      table_of({"chart", "newton", "--thickness", "0:1e9nm:5e7nm", "--side", "reflected", "--format", "csv"}), "Y");
  const double incoherent =
      numbers(json_of({"color", "air | water 1mm incoherent | air", "--format", "json"}).root, "XYZ")[1];
  for (std::size_t i = 1; i < thick.size(); ++i) EXPECT_NEAR(thick[i], incoherent, 1e-5) << i;
}

TEST(Chart, ThickFilmsStayLegible) {
  const auto svg_of = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"chart", "newton"});
    arguments.insert(arguments.end(), {"--format", "svg"});
    return run(arguments).out;
  };
  // The last number of the axis stays in the drawing, 1000 px wide; digits are 0.636 of 12 px wide.
  const std::string wide = svg_of({"air | glass 0nm incoherent | air", "--thickness", "0:1mm"});
  const std::size_t end = wide.find(">1000000</text>");
  ASSERT_NE(end, std::string::npos);
  const std::size_t at = wide.rfind("x=\"", end) + 3;
  EXPECT_LT(*parse_number(wide.substr(at, wide.find('"', at) - at)) + 7 * 0.636 * 12 / 2, 1000);
  // Lengths in their own unit, and few marks of orders.
  const std::string thick =
      svg_of({"air | 1.5 0nm | glass 1mm incoherent | air", "--layer", "1", "--thickness", "0:100um"});
  EXPECT_NE(thick.find("1.5 d | N-BK7 1 mm incoherent"), std::string::npos);
  EXPECT_NE(thick.find(">1\u201350<"), std::string::npos);
  EXPECT_NE(thick.find(">51\u2013100<"), std::string::npos);
  int strokes = 0;
  for (std::size_t i = thick.find("<line"); i != std::string::npos; i = thick.find("<line", i + 1)) ++strokes;
  EXPECT_LT(strokes, 300);
}

// An order is 550 nm of path difference: 550 / (2 n cos) of thickness.
TEST(Chart, OrdersFollowTheIndexAndTheAngle) {
  const auto first_end = [](const std::string& index, const std::string& angle) {
    const std::string svg = result_of({"chart", "newton", "1 | " + index + " 0nm | 1", "--thickness", "0:1000nm:10nm",
                                       "--angle", angle, "--side", "reflected", "--format", "svg"});
    // The second upright stroke above the strip is the end of the first order; the plot is 72..976 px wide.
    std::size_t at = svg.find("<line");
    std::vector<double> upright;
    for (; at != std::string::npos && upright.size() < 2; at = svg.find("<line", at + 1)) {
      double x1 = 0, y1 = 0, x2 = 0;
      if (std::sscanf(svg.c_str() + at, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\"", &x1, &y1, &x2) == 3 && x1 == x2)
        upright.push_back(x1);
    }
    return upright.size() == 2 ? (upright[1] - 72) / (976 - 72) * 1000 : NAN;
  };
  EXPECT_NEAR(first_end("1.5", "0"), 550 / (2 * 1.5), 0.1);
  EXPECT_NEAR(first_end("2", "0"), 550 / (2 * 2.0), 0.1);
  EXPECT_NEAR(first_end("1.5", "60"), 550 / (2 * std::sqrt(1.5 * 1.5 - 0.75)), 0.1);
}

TEST(Chart, SeveralAnglesOfASpectrumStayLegible) {
  const std::string svg =
      result_of({"spectrum", "air | 2+0.1i 300nm | air", "--angle", "0,10,20,30,40,50,60,70,80,85", "--format", "svg"});
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* part : {"R, reflected", "T, transmitted", "A, absorbed", "s solid, p dashed"})
    EXPECT_EQ(count(svg, part), 1u) << part;
  EXPECT_EQ(count(svg, "<path"), 60u);
  EXPECT_LE(count(svg, "\u00B0<"), 9u) << "entries of the legend";
}

}  // namespace
}  // namespace shabon::test
