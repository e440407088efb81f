// shabon chart angle: the colours of a film over its thickness and the angle of incidence, as a map.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart.h"
#include "chart_colors.h"
#include "chart_swept.h"
#include "shabon/base/parallel.h"
#include "shabon/base/text.h"

namespace shabon::app {

namespace {

constexpr ChartRange default_thickness_nm{0, 1500, {}}, default_angle_deg{0, 90, {}};
constexpr int thickness_parts = 700, angle_parts = 90;
constexpr std::size_t most_cells = 1'000'000;
constexpr std::size_t default_side = 1;          // reflected
constexpr int width_px = 1000, height_px = 707;  // the sides of A4
constexpr int two_maps_height_px = 1280;
// What is computed is a grid of points; between them the picture is interpolated to at least these sizes.
constexpr std::size_t least_columns = 1050, least_rows = 540;

struct Side {
  desk::Side side = desk::Side::reflected;
  std::vector<std::vector<color::Xyz>> colors;  // of every angle, and within it of every thickness
  std::vector<double> factors;                  // of every angle
};

struct AngleMap {
  SweptFilm film;
  std::vector<double> thicknesses_nm, incidence_deg;
  std::vector<Side> sides;
  std::vector<std::string> notes;  // on the sides
};

Result<Side> compute(const AngleMap& map, desk::Side side, const ChartOptions& options) {
  Side computed{side, {}, {}};
  computed.colors.resize(map.incidence_deg.size());
  std::vector<Diagnostics> errors(map.incidence_deg.size());
  parallel_for(map.incidence_deg.size(), 0, [&](std::size_t a) {
    Result<std::vector<color::Xyz>> row =
        film_colors(map.film, options, map.thicknesses_nm, map.incidence_deg[a], side);
    if (row) {
      computed.colors[a] = std::move(*row);
    } else {
      errors[a] = row.errors();
    }
  });
  for (const Diagnostics& error : errors)
    if (!error.empty()) return error;
  computed.factors = display_factors(computed.colors, options);
  return computed;
}

Result<AngleMap> compute(const ChartOptions& options) {
  Result<SweptFilm> film = read_swept_film(options);
  if (!film) return film.errors();
  if (!options.angles_deg.list.empty())
    return fail(Failure::usage, "--angle: expected A:B or A:B:STEP in degrees, got a list");
  const ChartRange thickness = options.thickness_nm.value_or(default_thickness_nm);
  const ChartRange angle = options.angles_deg.range.value_or(default_angle_deg);
  AngleMap map{std::move(*film),
               thickness.values(thickness.step_or(thickness_parts)),
               angle.values(angle.step_or(angle_parts)),
               {},
               {}};
  if (map.thicknesses_nm.size() < 2 || map.incidence_deg.size() < 2)
    return fail(Failure::usage, "--thickness, --angle: expected at least two values of each, a smaller step");
  if (map.thicknesses_nm.size() * map.incidence_deg.size() > most_cells)
    return fail(Failure::usage,
                fmt::format("--thickness, --angle: expected at most {} colours, thicknesses times angles", most_cells));
  for (const desk::Side side : shown_sides(map.film, options, default_side, map.notes)) {
    Result<Side> computed = compute(map, side, options);
    if (!computed) return computed.errors();
    map.sides.push_back(std::move(*computed));
  }
  return map;
}

// How many parts each interval between `points` points is cut into.
std::size_t parts_for(std::size_t points, std::size_t least) { return std::max<std::size_t>(1, least / points); }

color::Xyz mix(color::Xyz a, double share, color::Xyz b) {
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)};
}

color::Xyz scaled(color::Xyz colour, double factor) {
  return {colour.x * factor, colour.y * factor, colour.z * factor};
}

// The pixel in the middle of each part, bilinear in light between the four points around it. The first row is the
// largest angle.
io::ChartPicture picture(const AngleMap& map, const Side& side, const Display& display) {
  const std::size_t across = parts_for(map.thicknesses_nm.size() - 1, least_columns);
  const std::size_t up = parts_for(map.incidence_deg.size() - 1, least_rows);
  const std::size_t columns = (map.thicknesses_nm.size() - 1) * across, rows = (map.incidence_deg.size() - 1) * up;
  io::ChartPicture picture{map.thicknesses_nm.front(),
                           map.thicknesses_nm.back(),
                           map.incidence_deg.front(),
                           map.incidence_deg.back(),
                           static_cast<int>(columns),
                           static_cast<int>(rows),
                           {}};
  picture.rgb.resize(3 * columns * rows);
  parallel_for(rows, 0, [&](std::size_t y) {
    const std::size_t from_below = rows - 1 - y, a = from_below / up;
    const double angle_share = (static_cast<double>(from_below % up) + 0.5) / static_cast<double>(up);
    const auto at = [&](std::size_t i) {
      return mix(scaled(side.colors[a][i], side.factors[a]), angle_share,
                 scaled(side.colors[a + 1][i], side.factors[a + 1]));
    };
    for (std::size_t x = 0; x < columns; ++x) {
      const double share = (static_cast<double>(x % across) + 0.5) / static_cast<double>(across);
      const io::Rgb8 rgb = shown_bytes(mix(at(x / across), share, at(x / across + 1)), 1, display);
      std::copy(rgb.begin(), rgb.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (y * columns + x)));
    }
  });
  return picture;
}

// Where the orders begin, over the angle: the lines along which a colour moves.
std::vector<io::ChartSeries> order_lines(const AngleMap& map) {
  std::vector<io::ChartSeries> lines;
  const double low = map.thicknesses_nm.front(), high = map.thicknesses_nm.back();
  for (const io::ChartSpan& order : order_spans(order_thickness_nm(map.film, map.incidence_deg.front()), low, high)) {
    io::ChartSeries& line = lines.emplace_back();
    line.color = "#000000";
    line.width_px = 0.8;
    const double share = order.low / order_thickness_nm(map.film, map.incidence_deg.front());
    for (const double angle_deg : map.incidence_deg) {
      const double thickness_nm = std::round(share) * order_thickness_nm(map.film, angle_deg);
      if (!(thickness_nm > low && thickness_nm <= high)) break;
      line.x.push_back(thickness_nm);
      line.y.push_back(angle_deg);
    }
  }
  return lines;
}

// "5 x ", or nothing where every order has a line.
std::string every(const AngleMap& map) {
  const std::size_t step = orders_per_mark(order_thickness_nm(map.film, map.incidence_deg.front()),
                                           map.thicknesses_nm.front(), map.thicknesses_nm.back());
  return step == 1 ? "" : fmt::format("{} \u00D7 ", step);
}

io::ChartPlot plot(const AngleMap& map, const Side& side, const ChartOptions& options) {
  io::ChartPlot plot;
  plot.y = {"angle of incidence (degrees)", map.incidence_deg.front(), map.incidence_deg.back()};
  plot.picture = picture(map, side, display_of(options));
  if (options.curves && has_orders(map.film, options)) plot.series = order_lines(map);
  const std::string brightness = options.exposure == ChartExposure::each ? "" : factor_text(side.factors.front());
  plot.heading = fmt::format("{} light{}", name_of(side.side), brightness.empty() ? "" : ", brightness " + brightness);
  return plot;
}

io::Chart draw(const AngleMap& map, const ChartOptions& options) {
  io::Chart chart;
  static_cast<io::ChartPlot&>(chart) = plot(map, map.sides[0], options);
  for (std::size_t i = 1; i < map.sides.size(); ++i) chart.further.push_back(plot(map, map.sides[i], options));
  chart.title = fmt::format("Colour over thickness and angle: {}", title_text(map.film));
  chart.subtitle = fmt::format("unpolarised light, {}", light_text(options));
  if (options.interference() != optics::Interference::airy)
    chart.subtitle += fmt::format(", interference '{}'", optics::name_of(options.interference()));
  chart.x = {thickness_label(map.film), map.thicknesses_nm.front(), map.thicknesses_nm.back()};
  chart.width_px = width_px;
  chart.height_px = map.sides.size() > 1 ? two_maps_height_px : height_px;
  if (options.exposure == ChartExposure::each)
    chart.notes.push_back("Each angle is brightened until its brightest colour has Y = 1.");
  if (!chart.series.empty())
    chart.notes.push_back(fmt::format(
        "Lines: the path difference 2 n d cos \u03B8 in the film is a whole multiple of {}550 nm.", every(map)));
  chart.notes.insert(chart.notes.end(), map.notes.begin(), map.notes.end());
  chart.notes.push_back(display_note(options));
  return chart;
}

std::string table(const AngleMap& map, const ChartOptions& options) {
  std::string csv = "# Colours over thickness and angle of the stack " + printable(map.film.expression) + "\n";
  csv += fmt::format("# thickness_nm: of layer {}; angle_deg: of incidence; unpolarised light; interference '{}'\n",
                     map.film.layer + 1, optics::name_of(options.interference()));
  for (const std::string& note : map.notes) csv += "# " + note + "\n";
  csv += color_comments(options, film_sums) + "side,angle_deg,thickness_nm," + std::string(color_columns) + "\n";
  const Display display = display_of(options);
  for (const Side& side : map.sides)
    for (std::size_t a = 0; a < map.incidence_deg.size(); ++a)
      for (std::size_t i = 0; i < map.thicknesses_nm.size(); ++i)
        csv +=
            fmt::format("{},{},{},{}\n", name_of(side.side), format_number(map.incidence_deg[a]),
                        format_number(map.thicknesses_nm[i]), color_cells(side.colors[a][i], side.factors[a], display));
  return csv;
}

}  // namespace

Result<MadeChart> make_angle_chart(const ChartOptions& options) {
  const Result<AngleMap> map = compute(options);
  if (!map) return map.errors();
  MadeChart chart;
  if (options.wants_drawing) chart.drawing = draw(*map, options);
  if (options.wants_table) chart.csv = table(*map, options);
  chart.warnings = film_warnings(map->film, map->notes);
  return chart;
}

}  // namespace shabon::app
