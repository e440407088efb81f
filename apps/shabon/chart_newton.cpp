// shabon chart newton: the colours of a film over its thickness, as strips.
#include <fmt/format.h>

#include <algorithm>

#include "chart.h"
#include "chart_colors.h"
#include "chart_swept.h"
#include "shabon/base/text.h"

namespace shabon::app {

namespace {

constexpr ChartRange default_thickness_nm{0, 2000, {}};
constexpr std::size_t default_side = 0;  // both
constexpr int least_parts = 1500;        // of the range: steps of 1 nm over 2000 nm
constexpr int width_px = 1000, single_strip_px = 96, strip_px = 46;

struct Newton {
  SweptFilm film;
  std::vector<double> thicknesses_nm, incidence_deg;
  std::vector<SideColors> sides;
  std::vector<std::string> notes;  // on the sides
};

std::string degrees(double angle_deg) { return format_number(angle_deg, 6) + "\u00B0"; }

Result<Newton> compute(const ChartOptions& options) {
  Result<SweptFilm> film = read_swept_film(options);
  if (!film) return film.errors();
  Newton newton{std::move(*film), {}, options.angles_deg.values({0}), {}, {}};
  const std::vector<desk::Side> sides = shown_sides(newton.film, options, default_side, newton.notes);
  if (newton.incidence_deg.size() * sides.size() > most_strips)
    return fail(Failure::usage, fmt::format("--angle: expected at most {} strips, got {}", most_strips,
                                            newton.incidence_deg.size() * sides.size()));
  const ChartRange range = options.thickness_nm.value_or(default_thickness_nm);
  newton.thicknesses_nm = range.values(range.step_or(least_parts));
  if (newton.thicknesses_nm.size() < 2)
    return fail(Failure::usage, "--thickness: expected at least two values, a smaller step");
  for (const desk::Side side : sides) {
    SideColors computed{side, {}, {}};
    for (const double angle_deg : newton.incidence_deg) {
      Result<std::vector<color::Xyz>> colors =
          film_colors(newton.film, options, newton.thicknesses_nm, angle_deg, side);
      if (!colors) return colors.errors();
      computed.colors.push_back(std::move(*colors));
    }
    computed.factors = display_factors(computed.colors, options);
    newton.sides.push_back(std::move(computed));
  }
  return newton;
}

// Each colour stands for the thicknesses around its own, half a step to either side.
io::ChartStrip strip(const Newton& newton, const SideColors& side, std::size_t angle, const ChartOptions& options) {
  io::ChartStrip strip;
  const std::vector<double>& thicknesses_nm = newton.thicknesses_nm;
  const double half = (thicknesses_nm[1] - thicknesses_nm[0]) / 2;
  strip.low = thicknesses_nm.front() - half;
  strip.high = thicknesses_nm.back() + half;
  const Display display = display_of(options);
  for (const color::Xyz& colour : side.colors[angle])
    strip.colors.push_back(shown_bytes(colour, side.factors[angle], display));
  const double incidence_deg = newton.incidence_deg[angle];
  if (has_orders(newton.film, options))
    strip.spans =
        order_spans(order_thickness_nm(newton.film, incidence_deg), thicknesses_nm.front(), thicknesses_nm.back());
  const std::string brightness = factor_text(side.factors[angle]);
  strip.label = fmt::format("{} at {}{}", name_of(side.side), degrees(incidence_deg),
                            brightness.empty() ? "" : ", brightness " + brightness);
  return strip;
}

struct Curve {
  const char *name, *color;
  bool dashed;
  double (*value)(color::Xyz);
};

constexpr Curve curves[] = {
    {"Y", "#1a1a1a", false, [](color::Xyz c) { return c.y; }},
    {"linear sRGB: red", "#d62728", false, [](color::Xyz c) { return color::xyz_to_linear_srgb(c).r; }},
    {"green", "#2ca02c", false, [](color::Xyz c) { return color::xyz_to_linear_srgb(c).g; }},
    {"blue", "#1f5fd6", false, [](color::Xyz c) { return color::xyz_to_linear_srgb(c).b; }},
};

// At one angle Y and the components of linear sRGB; at several Y alone, a line for each.
io::ChartPlot curve_plot(const Newton& newton, const SideColors& side, bool legend) {
  io::ChartPlot plot;
  plot.heading = fmt::format("{} light, as it is (the lamp has Y = 1)", name_of(side.side));
  const auto add = [&](std::size_t angle, const Curve& curve, const std::string& label, const std::string& color) {
    io::ChartSeries& series = plot.series.emplace_back();
    if (legend) series.label = label;
    series.color = color;
    series.x = newton.thicknesses_nm;
    for (const color::Xyz& colour : side.colors[angle]) series.y.push_back(curve.value(colour));
  };
  const std::size_t angles = newton.incidence_deg.size();
  if (angles == 1) {
    plot.y.label = "Y and linear sRGB";
    for (const Curve& curve : curves) add(0, curve, curve.name, curve.color);
  } else {
    plot.y.label = "Y";
    for (std::size_t a = 0; a < angles; ++a)
      add(a, curves[0], "Y at " + degrees(newton.incidence_deg[a]), io::sequence_color(a, angles));
  }
  return plot;
}

io::Chart draw(const Newton& newton, const ChartOptions& options) {
  io::Chart chart;
  chart.title = "Newton's colours: " + title_text(newton.film);
  chart.subtitle = fmt::format("unpolarised light, {}", light_text(options));
  if (options.interference() != optics::Interference::airy)
    chart.subtitle += fmt::format(", interference '{}'", optics::name_of(options.interference()));
  chart.x = {thickness_label(newton.film), newton.thicknesses_nm.front(), newton.thicknesses_nm.back()};
  chart.width_px = width_px;
  chart.height_px = 0;
  std::size_t strips = 0;
  for (const SideColors& side : newton.sides) {
    for (std::size_t a = 0; a < newton.incidence_deg.size(); ++a, ++strips)
      chart.strips.push_back(strip(newton, side, a, options));
    if (options.curves) chart.further.push_back(curve_plot(newton, side, &side == &newton.sides.front()));
  }
  chart.strip_height_px = strips <= 2 ? single_strip_px : strip_px;
  const bool orders = std::any_of(chart.strips.begin(), chart.strips.end(),
                                  [](const io::ChartStrip& strip) { return !strip.spans.empty(); });
  chart.notes = newton.notes;
  if (orders)
    chart.notes.push_back(
        "Orders: path difference 2 n d cos \u03B8 in the film, in steps of 550 nm, with n at 550 nm.");
  chart.notes.push_back(display_note(options));
  return chart;
}

std::string table(const Newton& newton, const ChartOptions& options) {
  std::string csv = "# Newton's colours of the stack " + printable(newton.film.expression) + "\n";
  csv += fmt::format("# thickness_nm: of layer {}; angle_deg: of incidence; unpolarised light; interference '{}'\n",
                     newton.film.layer + 1, optics::name_of(options.interference()));
  for (const std::string& note : newton.notes) csv += "# " + note + "\n";
  csv += color_comments(options, film_sums) + "side,angle_deg,thickness_nm," + std::string(color_columns) + "\n";
  const Display display = display_of(options);
  for (const SideColors& side : newton.sides)
    for (std::size_t a = 0; a < newton.incidence_deg.size(); ++a)
      for (std::size_t i = 0; i < newton.thicknesses_nm.size(); ++i)
        csv += fmt::format("{},{},{},{}\n", name_of(side.side), format_number(newton.incidence_deg[a]),
                           format_number(newton.thicknesses_nm[i]),
                           color_cells(side.colors[a][i], side.factors[a], display));
  return csv;
}

}  // namespace

Result<MadeChart> make_newton_chart(const ChartOptions& options) {
  const Result<Newton> newton = compute(options);
  if (!newton) return newton.errors();
  MadeChart chart;
  if (options.wants_drawing) chart.drawing = draw(*newton, options);
  if (options.wants_table) chart.csv = table(*newton, options);
  chart.warnings = film_warnings(newton->film, newton->notes);
  return chart;
}

}  // namespace shabon::app
