#include "shabon/io/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "../../well_formed_xml.h"
#include "shabon/base/text.h"
#include "shabon/io/image.h"
#include "shabon/io/svg_elements.h"

namespace shabon::io {
namespace {

using Frame = svg::Box;

using test::count;
using test::is_well_formed;

Chart test_chart() {
  Chart chart;
  chart.title = "Reflectance <of> \"soap\" & water";
  chart.x.label = "wavelength (nm)";
  chart.y.label = "R";
  chart.series = {{"R_s", "", false, {360, 500, 830}, {0, 0.5, 1}}, {"R_p", "#ff0000", true, {360, 830}, {0.2, 0.3}}};
  return chart;
}

TEST(Ticks, AreRoundNumbersInside) {
  EXPECT_EQ(nice_ticks(0, 1, 5), (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_EQ(nice_ticks(360, 830, 5), (std::vector<double>{400, 500, 600, 700, 800}));
  EXPECT_EQ(nice_ticks(-0.3, 0.3, 6), (std::vector<double>{-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3}));
  EXPECT_EQ(nice_ticks(0, 4e-12, 4), (std::vector<double>{0, 1e-12, 2e-12, 3e-12, 4e-12}));
  for (double scale : {1e-300, 1e-9, 1.0, 7.3, 1e12, 1e300})
    for (int wanted : {1, 2, 5, 20}) {
      const auto ticks = nice_ticks(-0.37 * scale, 1.12 * scale, wanted);
      EXPECT_GE(ticks.size(), 1u);
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(3 * wanted + 1));
      for (double tick : ticks) EXPECT_TRUE(tick >= -0.3701 * scale && tick <= 1.1201 * scale) << tick;
    }
}

TEST(Ticks, RefuseWhatIsNoRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(nice_ticks(1, 1, 5).empty());
  EXPECT_TRUE(nice_ticks(2, 1, 5).empty());
  EXPECT_TRUE(nice_ticks(0, infinity, 5).empty());
  EXPECT_TRUE(nice_ticks(NAN, 1, 5).empty());
  EXPECT_TRUE(nice_ticks(0, 1, 0).empty());
  EXPECT_LE(nice_ticks(0, 1, 1'000'000'000).size(), 2100u);
  EXPECT_LE(nice_ticks(1e15, 1e15 + 1, 100).size(), 2100u);
}

TEST(Svg, DrawsEverySeriesLabelAndTick) {
  const std::string svg = chart_svg(test_chart());
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "<path"), 2u);
  EXPECT_NE(svg.find("Reflectance &lt;of&gt; &quot;soap&quot; &amp; water"), std::string::npos);
  for (const char* text :
       {">R_s<", ">R_p<", ">wavelength (nm)<", ">R<", ">400<", ">800<", ">0.2<", "#ff0000", "dasharray"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

// The numbers of the attributes of the first element that begins with `element` after `from`.
Frame box_of(const std::string& svg, const std::string& element, std::size_t from = 0) {
  const std::size_t at = svg.find(element, from);
  const auto number = [&](const std::string& name) {
    return std::stod(svg.substr(svg.find(name + "=\"", at) + name.size() + 2));
  };
  Frame box;
  box.left = number(" x"), box.top = number(" y");
  box.right = box.left + number(" width"), box.bottom = box.top + number(" height");
  return box;
}

TEST(Svg, PutsPointsWhereTheAxesSay) {
  Chart chart;
  chart.x.low = 0, chart.x.high = 10, chart.y.low = 0, chart.y.high = 1;
  chart.series = {{"", "", false, {0, 10}, {0, 1}}};
  const std::string svg = chart_svg(chart);
  // The outline is the plot: the line runs from its lower left to its upper right corner.
  const Frame plot = box_of(svg, "<rect", svg.rfind("<rect", svg.find("fill=\"none\" stroke=\"#333333\"")));
  double x0, y0, x1, y1;
  const std::size_t path = svg.find("d=\"M") + 4;
  ASSERT_EQ(std::sscanf(svg.c_str() + path, "%lf %lfL%*f %*fL%lf %lf", &x0, &y0, &x1, &y1), 4);
  EXPECT_NEAR(x0, plot.left, 0.02);
  EXPECT_NEAR(y0, plot.bottom, 0.02);
  EXPECT_NEAR(x1, plot.right, 0.02);
  EXPECT_NEAR(y1, plot.top, 0.02);
}

TEST(Svg, LeavesGaps) {
  Chart chart;
  chart.series = {{"", "", false, {0, 1, 2, 3}, {0, NAN, 1, 2}}};
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(count(svg.substr(svg.find("d=\"")), "M"), 2u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

// The pictures embedded in a drawing, in its order.
std::vector<Rgb8Image> pictures_in(const std::string& svg) {
  constexpr std::string_view head = "data:image/png;base64,";
  std::vector<Rgb8Image> pictures;
  for (std::size_t at = svg.find(head); at != std::string::npos; at = svg.find(head, at + 1)) {
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (std::size_t i = at + head.size(); svg[i] != '"' && svg[i] != '='; ++i) {
      constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      bits = bits << 6 | static_cast<std::uint32_t>(alphabet.find(svg[i]));
      if ((held += 6) >= 8) bytes += static_cast<char>(bits >> (held -= 8));
    }
    const Result<Rgb8Image> picture = decode_png(bytes, "picture");
    EXPECT_TRUE(picture.ok());
    if (picture) pictures.push_back(*picture);
  }
  return pictures;
}

// The colours of a row of `count` patches of equal width, each of one colour throughout.
std::vector<Rgb8> patches(const Rgb8Image& row, int count) {
  EXPECT_EQ(row.height, 1);
  EXPECT_EQ(row.width % count, 0);
  const int wide = row.width / count;
  EXPECT_GE(row.width, 2000) << "sharp in print";
  std::vector<Rgb8> colors;
  for (int x = 0; x < row.width; ++x) {
    const auto at = static_cast<std::size_t>(3 * x);
    const Rgb8 color{row.rgb[at], row.rgb[at + 1], row.rgb[at + 2]};
    if (x % wide == 0) colors.push_back(color);
    EXPECT_EQ(color, colors.back()) << x;
  }
  return colors;
}

TEST(Svg, DrawsStripsAlone) {
  Chart chart;
  chart.strips.resize(2);
  chart.strips[0].label = "Airy";
  chart.strips[0].high = 1000;
  chart.strips[0].colors = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
  chart.strips[0].spans = {{0, 300, "1st order"}, {300, 310, "2nd order"}, {320, 350, "3rd order", "3"}};
  chart.strips[1].side_label = "60\u00B0";
  chart.strips[1].low = 500, chart.strips[1].high = 1000;
  chart.strips[1].colors = {{128, 128, 128}};
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  const std::vector<Rgb8Image> pictures = pictures_in(svg);
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_EQ(patches(pictures[0], 3), (std::vector<Rgb8>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}}));
  EXPECT_EQ(patches(pictures[1], 1), (std::vector<Rgb8>{{128, 128, 128}}));
  EXPECT_NE(svg.find(">1000<"), std::string::npos);
  EXPECT_NE(svg.find(">1st order<"), std::string::npos);
  EXPECT_EQ(svg.find(">2nd order<"), std::string::npos) << "wider than its part";
  EXPECT_EQ(svg.find(">3rd order<"), std::string::npos) << "wider than its part";
  EXPECT_NE(svg.find(">3<"), std::string::npos);
}

TEST(Svg, PutsAPictureWhereTheAxesSay) {
  Chart chart;
  chart.x.low = 0, chart.x.high = 10, chart.y.low = 0, chart.y.high = 90;
  chart.picture = ChartPicture{2, 12, 45, 90, 2, 2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  const std::size_t clip = svg.find("<clipPath");
  ASSERT_NE(clip, std::string::npos) << "the picture leaves the plot";
  const Frame plot = box_of(svg, "<rect", clip), picture = box_of(svg, "<image");
  EXPECT_NEAR(picture.left, plot.left + 0.2 * plot.width(), 0.02);
  EXPECT_NEAR(picture.right, plot.left + 1.2 * plot.width(), 0.02);
  EXPECT_NEAR(picture.top, plot.top, 0.02);
  EXPECT_NEAR(picture.bottom, plot.top + plot.height() / 2, 0.02);
  ASSERT_EQ(pictures_in(svg).size(), 1u);
  EXPECT_EQ(pictures_in(svg)[0].rgb, chart.picture->rgb);
  chart.picture->rows = 3;
  EXPECT_EQ(chart_svg(chart).find("<image"), std::string::npos) << "the sizes do not fit";
}

// The labels stand beyond the ends of their lines, and one that would cover an earlier one is left out.
TEST(Svg, LabelsTheEndsOfLines) {
  Chart chart;
  chart.x.low = 0, chart.x.high = 100, chart.y.low = 0, chart.y.high = 50;
  chart.picture = ChartPicture{0, 100, 0, 50, 1, 1, {0, 0, 0}};
  const auto add = [&](double x, double y, const std::string& label) {
    ChartSeries& series = chart.series.emplace_back();
    series.x = {0, x}, series.y = {0, y}, series.end_label = label;
  };
  add(50, 50, "up");
  add(100, 25, "right");
  add(50.2, 50, "hidden");
  add(70, 50, "beside");
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(svg.find("<clipPath"), std::string::npos);
  for (const char* label : {">up<", ">right<", ">beside<"}) EXPECT_NE(svg.find(label), std::string::npos) << label;
  EXPECT_EQ(svg.find(">hidden<"), std::string::npos);
}

TEST(Svg, DrawsSeveralPlotsOverOneAxis) {
  Chart chart = test_chart();
  chart.heading = "reflected";
  chart.further.resize(2);
  chart.further[0].heading = "transmitted";
  chart.further[0].series = {{"T", "", false, {360, 900}, {0, 1}}};
  chart.further[0].rules = {{0.5, "half"}};
  chart.further[1].heading = "empty";
  chart.notes = {"first note", "second note"};
  chart.spans = {{400, 700, "visible"}};
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "<path"), 3u);
  EXPECT_EQ(count(svg, ">900<"), 1u) << "one axis with numbers";
  for (const char* text : {">reflected<", ">transmitted<", ">half<", ">first note<", ">second note<", ">visible<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find(">empty<"), std::string::npos);
}

TEST(Svg, SequencesRunFromDarkToLight) {
  EXPECT_EQ(sequence_color(0, 1), "#440154");
  EXPECT_EQ(sequence_color(0, 5), "#440154");
  EXPECT_EQ(sequence_color(4, 5), "#5ec962");
  EXPECT_EQ(sequence_color(9, 5), "#5ec962");
  std::set<std::string> colors;
  for (std::size_t i = 0; i < 50; ++i) colors.insert(sequence_color(i, 50));
  EXPECT_EQ(colors.size(), 50u);
}

TEST(Svg, DrawsAnyChart) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
  std::vector<Chart> charts(8, test_chart());
  charts[0] = Chart{};
  charts[1].series[0].y = {NAN, infinity, -infinity};
  charts[2].series[0].x = {-largest, 0, largest};
  charts[3].series[0].y = {7, 7, 7};
  charts[4].series[0].y.clear();
  charts[5].width_px = charts[5].height_px = -10;
  charts[6].x.low = 5, charts[6].x.high = 5, charts[6].y.low = NAN;
  charts[7].title = std::string("a\0\x01\xFF]]>", 8);
  charts[7].strips.assign(40, {"x\"/><script>", "</text>", NAN, 1, {{1, 2, 3}}, {{NAN, infinity, "<x>"}}});
  charts[7].picture = ChartPicture{-infinity, NAN, 1, 0, -1, 1, {}};
  charts[7].rules = {{NAN, "\x02"}};
  for (const Chart& chart : charts) {
    const std::string svg = chart_svg(chart);
    EXPECT_TRUE(is_well_formed(svg)) << svg;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
  }
}

// A rule's label makes room for the lines, and where it cannot they are drawn over its box.
TEST(Svg, LabelsOfRulesHideNoLine) {
  Chart chart;
  chart.y = {"", 0.0, 1.0};
  chart.x = {"", 0.0, 1.0};
  chart.rules = {{0.5, "half"}};
  const auto left_of_box = [](const std::string& svg) {
    const std::size_t at = svg.find("x=\"", svg.rfind("<rect", svg.find("rx=\"3\""))) + 3;
    return *parse_number(svg.substr(at, svg.find('"', at) - at));
  };
  const double alone = left_of_box(chart_svg(chart));
  chart.series.push_back({"", "#123456", false, {0.94, 0.94}, {0, 1}});
  const std::string svg = chart_svg(chart);
  EXPECT_LT(left_of_box(svg), alone);
  EXPECT_LT(svg.find("rx=\"3\""), svg.find("#123456"));
}

}  // namespace
}  // namespace shabon::io
