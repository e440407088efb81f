#include "shabon/io/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shabon::io {
namespace {

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Every tag closed in order, every attribute in quotes, no bare '&' or '<': well-formed XML as far as this writer goes.
bool is_well_formed(std::string_view xml) {
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = xml.find('<', at)) != std::string_view::npos;) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return false;
    std::string_view tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.find('<') != std::string_view::npos || count(tag, "\"") % 2 != 0) return false;
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.emplace_back(tag.substr(0, tag.find(' ')));
    } else {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    }
  }
  for (std::size_t at = 0; (at = xml.find('&', at)) != std::string_view::npos; ++at)
    if (xml.substr(at, 5) != "&amp;" && xml.substr(at, 4) != "&lt;" && xml.substr(at, 4) != "&gt;" &&
        xml.substr(at, 6) != "&quot;")
      return false;
  return open.empty();
}

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

TEST(Svg, PutsPointsWhereTheAxesSay) {
  Chart chart;
  chart.x.low = 0, chart.x.high = 10, chart.y.low = 0, chart.y.high = 1;
  chart.series = {{"", "", false, {0, 10}, {0, 1}}};
  const std::string svg = chart_svg(chart);
  // The clip rectangle is the plot: the line runs from its lower left to its upper right corner.
  const std::size_t rect = svg.find("<rect", svg.find("clipPath"));
  const auto number_after = [&](const std::string& name) {
    return std::stod(svg.substr(svg.find(name, rect) + name.size()));
  };
  const double left = number_after(" x=\""), top = number_after(" y=\"");
  const double right = left + number_after(" width=\""), bottom = top + number_after(" height=\"");
  double x0, y0, x1, y1;
  const std::size_t path = svg.find("d=\"M") + 4;
  ASSERT_EQ(std::sscanf(svg.c_str() + path, "%lf %lfL%*f %*fL%lf %lf", &x0, &y0, &x1, &y1), 4);
  EXPECT_NEAR(x0, left, 0.02);
  EXPECT_NEAR(y0, bottom, 0.02);
  EXPECT_NEAR(x1, right, 0.02);
  EXPECT_NEAR(y1, top, 0.02);
}

TEST(Svg, LeavesGaps) {
  Chart chart;
  chart.series = {{"", "", false, {0, 1, 2, 3}, {0, NAN, 1, 2}}};
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(count(svg.substr(svg.find("d=\"")), "M"), 2u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Svg, DrawsStripsAlone) {
  Chart chart;
  chart.strips = {{"Airy", 0, 1000, {"#ff0000", "#00ff00", "#0000ff"}}, {"", 500, 1000, {"#808080"}}};
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "fill=\"#00ff00\""), 1u);
  EXPECT_EQ(count(svg, "fill=\"#808080\""), 1u);
  EXPECT_NE(svg.find(">1000<"), std::string::npos);
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
  charts[7].strips.assign(40, {"x", NAN, 1, {"\"/><script>"}});
  for (const Chart& chart : charts) {
    const std::string svg = chart_svg(chart);
    EXPECT_TRUE(is_well_formed(svg)) << svg;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
  }
}

}  // namespace
}  // namespace shabon::io
