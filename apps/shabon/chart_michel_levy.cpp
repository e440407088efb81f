// shabon chart michel-levy: the colours of birefringent minerals between crossed polarisers, as mineralogists print
// them: retardation along the bottom, thickness up the side, a fan of lines of equal birefringence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart.h"
#include "chart_colors.h"
#include "chart_swept.h"
#include "shabon/base/text.h"
#include "shabon/desk/retardation.h"

namespace shabon::app {

namespace {

constexpr ChartRange default_retardation_nm{0, 2500, {}}, default_thickness_nm{0, 50'000, {}};
constexpr int least_parts = 2000;
constexpr double nm_per_um = 1000;
constexpr double thin_section_um = 30;           // the standard thickness of a petrographic thin section
constexpr int width_px = 1000, height_px = 707;  // the sides of A4

// The lines drawn unless others are asked for. Those before the bar come first where labels would meet.
constexpr double strong_lines[] = {0.005, 0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.04, 0.045,
                                   0.05,  0.06, 0.07,  0.08, 0.1,   0.12, 0.15,  0.2,  0.3};
constexpr double fine_lines[] = {0.001, 0.002, 0.003, 0.004, 0.006, 0.007, 0.008, 0.009};

struct MichelLevy {
  std::vector<double> retardations_nm;
  ChartRange thickness_nm;
  std::vector<std::vector<color::Xyz>> colors;  // one row
  double factor = 1;
};

MichelLevy compute(const ChartOptions& options) {
  const ChartRange range = options.retardation_nm.value_or(default_retardation_nm);
  MichelLevy levy{range.values(range.step_or(least_parts)), options.thickness_nm.value_or(default_thickness_nm), {}, 1};
  levy.colors = {desk::retardation_colors(levy.retardations_nm, options.lamp, options.observer())};
  levy.factor = display_factors(levy.colors, options)[0];
  return levy;
}

// With three decimals where they are enough: 0.010.
std::string birefringence_text(double birefringence) {
  const std::string text = fmt::format("{:.3f}", birefringence);
  return parse_number(text) == birefringence ? text : format_number(birefringence, 6);
}

// The part of the line retardation = birefringence x thickness within the chart; none where it misses it.
void add_line(io::Chart& chart, const MichelLevy& levy, double birefringence, double width) {
  const double left = levy.retardations_nm.front(), right = levy.retardations_nm.back();
  const double from_nm = std::max(levy.thickness_nm.low, left / birefringence);
  const double to_nm = std::min(levy.thickness_nm.high, right / birefringence);
  if (!(to_nm > from_nm)) return;
  io::ChartSeries& line = chart.series.emplace_back();
  line.color = "#000000";
  line.width_px = width;
  line.x = {desk::retardation_nm(birefringence, from_nm), std::min(desk::retardation_nm(birefringence, to_nm), right)};
  line.y = {from_nm / nm_per_um, to_nm / nm_per_um};
  line.end_label = birefringence_text(birefringence);
}

void add_fan(io::Chart& chart, const MichelLevy& levy, const std::vector<double>& asked) {
  constexpr double strong_px = 1.1, fine_px = 0.6;
  for (const double birefringence : asked) add_line(chart, levy, birefringence, strong_px);
  if (!asked.empty()) return;
  for (const double birefringence : strong_lines) add_line(chart, levy, birefringence, strong_px);
  for (const double birefringence : fine_lines) add_line(chart, levy, birefringence, fine_px);
}

io::ChartPicture picture(const MichelLevy& levy, const Display& display) {
  const double half = (levy.retardations_nm[1] - levy.retardations_nm[0]) / 2;
  io::ChartPicture picture{levy.retardations_nm.front() - half,
                           levy.retardations_nm.back() + half,
                           levy.thickness_nm.low / nm_per_um,
                           levy.thickness_nm.high / nm_per_um,
                           static_cast<int>(levy.retardations_nm.size()),
                           1,
                           {}};
  for (const color::Xyz& colour : levy.colors[0]) {
    const io::Rgb8 rgb = shown_bytes(colour, levy.factor, display);
    picture.rgb.insert(picture.rgb.end(), rgb.begin(), rgb.end());
  }
  return picture;
}

io::Chart draw(const MichelLevy& levy, const ChartOptions& options) {
  io::Chart chart;
  chart.title = "Michel-L\u00E9vy chart: interference colours between crossed polarisers";
  chart.subtitle = fmt::format("retardation = birefringence \u00D7 thickness; {}", light_text(options));
  chart.x = {"retardation (nm)", levy.retardations_nm.front(), levy.retardations_nm.back()};
  chart.y = {"thickness (\u00B5m)", levy.thickness_nm.low / nm_per_um, levy.thickness_nm.high / nm_per_um};
  chart.width_px = width_px;
  chart.height_px = height_px;
  chart.picture = picture(levy, display_of(options));
  chart.spans = order_spans(desk::order_retardation_nm, levy.retardations_nm.front(), levy.retardations_nm.back());
  add_fan(chart, levy, options.birefringences);
  chart.end_title = "birefringence";
  if (levy.thickness_nm.low < thin_section_um * nm_per_um && levy.thickness_nm.high > thin_section_um * nm_per_um)
    chart.rules = {{thin_section_um, "thin section, 30 \u00B5m"}};
  const std::string brightness = factor_text(levy.factor);
  chart.notes = {
      "Light passed at 45\u00B0: sin\u00B2(\u03C0 retardation / wavelength), without dispersion of the "
      "birefringence. Orders of 550 nm." +
          (brightness.empty() ? "" : " Brightness " + brightness + "."),
      display_note(options)};
  return chart;
}

std::string table(const MichelLevy& levy, const ChartOptions& options) {
  std::string csv =
      "# Colours between crossed polarisers, plate at 45 degrees: sin^2(pi retardation / wavelength)\n"
      "# Y = 1 is the open field between parallel polarisers; no dispersion of the birefringence\n";
  csv += color_comments(options, plain_sums) + "retardation_nm,order," + std::string(color_columns) + "\n";
  const Display display = display_of(options);
  for (std::size_t i = 0; i < levy.retardations_nm.size(); ++i)
    csv += fmt::format("{},{},{}\n", format_number(levy.retardations_nm[i]),
                       std::floor(levy.retardations_nm[i] / desk::order_retardation_nm) + 1,
                       color_cells(levy.colors[0][i], levy.factor, display));
  return csv;
}

}  // namespace

Result<MadeChart> make_michel_levy_chart(const ChartOptions& options) {
  const MichelLevy levy = compute(options);
  if (levy.retardations_nm.size() < 2)
    return fail(Failure::usage, "--retardation: expected at least two values, a smaller step");
  MadeChart chart;
  if (options.wants_drawing) chart.drawing = draw(levy, options);
  if (options.wants_table) chart.csv = table(levy, options);
  return chart;
}

}  // namespace shabon::app
