#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "media_table.h"

namespace shabon::app {

namespace {

// Colours that the colour-blind can tell apart: M. Okabe, K. Ito, Color Universal Design (2008).
constexpr std::array<std::string_view, 7> line_colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#000000", "#56b4e9", "#e69f00"};

using Part = double (*)(std::complex<double>);
double real_part(std::complex<double> index) { return index.real(); }
double imaginary_part(std::complex<double> index) { return index.imag(); }

// The points that the source covers, or those that it does not with the nearest that it does, so that both lines meet.
io::ChartSeries line(const optics::Medium& medium, const std::vector<double>& wavelengths_nm, Part part, bool covered) {
  io::ChartSeries series;
  const std::size_t count = wavelengths_nm.size();
  const auto known = [&](std::size_t i) { return medium.covers(wavelengths_nm[i]); };
  for (std::size_t i = 0; i < count; ++i) {
    const bool beside = (i > 0 && !known(i - 1)) || (i + 1 < count && !known(i + 1));
    const bool drawn = covered ? known(i) : !known(i) || beside;
    series.x.push_back(wavelengths_nm[i]);
    series.y.push_back(drawn ? part(medium.index(wavelengths_nm[i])) : std::numeric_limits<double>::quiet_NaN());
  }
  series.dashed = !covered;
  return series;
}

// Small values are drawn in a power of ten that the label tells: "extinction k (in 10⁻⁶)".
void rescale(io::ChartPlot& plot) {
  constexpr double smallest_plain = 0.01;
  constexpr std::array<const char*, 10> digits = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                  "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  double largest = 0;
  for (const io::ChartSeries& series : plot.series)
    for (const double y : series.y) largest = std::isnan(y) ? largest : std::max(largest, y);
  if (largest <= 0 || largest >= smallest_plain) return;
  const int exponent = static_cast<int>(std::ceil(-std::log10(largest)));
  for (io::ChartSeries& series : plot.series)
    for (double& y : series.y) y *= std::pow(10.0, exponent);
  std::string power = "\u207B";
  for (const char c : std::to_string(exponent)) power += digits[static_cast<std::size_t>(c - '0')];
  plot.y.label += " (in 10" + power + ")";
}

// Only the plot above names the lines; they have one colour in both.
io::ChartPlot plot(const std::vector<optics::Medium>& media, const std::vector<double>& wavelengths_nm, Part part,
                   const char* label, bool named) {
  io::ChartPlot result;
  result.y.label = label;
  for (std::size_t i = 0; i < media.size(); ++i)
    for (const bool covered : {true, false}) {
      const auto is_one = [&](double nm) { return media[i].covers(nm) == covered; };
      if (std::none_of(wavelengths_nm.begin(), wavelengths_nm.end(), is_one)) continue;
      io::ChartSeries series = line(media[i], wavelengths_nm, part, covered);
      series.color = line_colors[i % line_colors.size()];
      const bool first = result.series.empty() || result.series.back().color != series.color;
      if (named && first && media.size() > 1) series.label = media[i].name();
      result.series.push_back(std::move(series));
    }
  return result;
}

}  // namespace

io::Chart media_chart(const MediaTable& table) {
  std::vector<double> wavelengths_nm = table.wavelengths_nm;
  std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
  const auto absorbs = [](const optics::Medium& medium) { return !medium.is_lossless(); };
  const bool dashed = std::any_of(table.media.begin(), table.media.end(), [&](const optics::Medium& medium) {
    return !medium.outside_range_note(wavelengths_nm).empty();
  });

  io::Chart chart;
  static_cast<io::ChartPlot&>(chart) = plot(table.media, wavelengths_nm, real_part, "refractive index n", true);
  chart.title = table.media.size() == 1 ? "Refractive index of " + table.media.front().name() : "Refractive indices";
  if (table.media.size() == 1) chart.subtitle = table.media.front().description();
  chart.x.label = "vacuum wavelength (nm)";
  if (std::any_of(table.media.begin(), table.media.end(), absorbs))
    rescale(chart.further.emplace_back(plot(table.media, wavelengths_nm, imaginary_part, "extinction k", false)));
  if (dashed) chart.notes.push_back("dashed: beyond what the source covers");
  chart.height_px = 0;
  return chart;
}

}  // namespace shabon::app
