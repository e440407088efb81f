// shabon chart profile: how thick a bubble's film is from its top to its bottom, and the colours that it has there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chart.h"
#include "chart_colors.h"
#include "chart_swept.h"
#include "shabon/api/resources.h"
#include "shabon/base/text.h"
#include "shabon/scene/thickness_text.h"

namespace shabon::app {

namespace {

constexpr std::size_t default_side = 1;  // reflected
constexpr int parts = 1000;              // equal in height, from top to bottom
constexpr int longitudes = 90;
constexpr int width_px = 1000, plot_px = 380, single_strip_px = 72, strip_px = 46;
constexpr double visible_share = 1e-3;  // a film that varies less around the bubble is told as the same all around

// The film at one time; one number for each height.
struct Profile {
  double time_s = 0;
  std::vector<double> thickness_nm;  // along the meridian through +z
  std::vector<double> least_nm, mean_nm, largest_nm;
  bool varies = false;  // around the bubble, visibly
};

struct Profiles {
  SweptFilm film;
  double incidence_deg = 0;
  std::vector<double> depths;  // below the top, in radii
  std::vector<Profile> profiles;
  std::vector<SideColors> sides;
  std::vector<std::string> notes;  // on the sides
  Diagnostics warnings;
};

std::string after(double time_s) { return fmt::format("after {} s", format_number(time_s, 6)); }

Profile profile(const film::ThicknessField& field, double time_s, const std::vector<double>& depths) {
  Profile made;
  made.time_s = time_s;
  for (const double depth : depths) {
    const double y = 1 - depth, across = std::sqrt(std::max(0.0, depth * (2 - depth)));
    double least = 0, largest = 0, sum = 0;
    for (int i = 0; i < longitudes; ++i) {
      const double turn = 2 * std::numbers::pi * i / longitudes;
      const double nm = film::thickness_nm(field, math::Vec3d{across * std::sin(turn), y, across * std::cos(turn)});
      if (i == 0) made.thickness_nm.push_back(nm), least = largest = nm;
      least = std::min(least, nm), largest = std::max(largest, nm), sum += nm;
    }
    made.least_nm.push_back(least);
    made.mean_nm.push_back(std::clamp(sum / longitudes, least, largest));
    made.largest_nm.push_back(largest);
    made.varies |= largest - least > visible_share * largest;
  }
  return made;
}

Result<Profiles> compute(const ChartOptions& options) {
  Result<SweptFilm> film = read_swept_film(options);
  if (!film) return film.errors();
  Profiles made{std::move(*film), 0, {}, {}, {}, {}, {}};
  const std::vector<double> incidence_deg = options.angles_deg.values({0});
  if (incidence_deg.size() != 1) return fail(Failure::usage, "--angle: expected one angle with profile");
  made.incidence_deg = incidence_deg.front();
  const std::vector<desk::Side> sides = shown_sides(made.film, options, default_side, made.notes);
  if (options.times_s.size() * sides.size() > most_strips)
    return fail(Failure::usage, fmt::format("--time: expected at most {} strips, got {}", most_strips,
                                            options.times_s.size() * sides.size()));
  auto fields = scene::read_thickness(options.model.value_or(default_profile_model), "--model", options.times_s,
                                      api::file_resources({}), &made.warnings);
  if (!fields) return fields.errors();
  for (int i = 0; i <= parts; ++i) made.depths.push_back(2.0 * i / parts);
  for (std::size_t t = 0; t < options.times_s.size(); ++t)
    made.profiles.push_back(profile((*fields)[t], options.times_s[t], made.depths));
  for (const desk::Side side : sides) {
    SideColors computed{side, {}, {}};
    for (const Profile& at : made.profiles) {
      Result<std::vector<color::Xyz>> colors =
          film_colors(made.film, options, at.thickness_nm, made.incidence_deg, side);
      if (!colors) return colors.errors();
      computed.colors.push_back(std::move(*colors));
    }
    computed.factors = display_factors(computed.colors, options);
    made.sides.push_back(std::move(computed));
  }
  return made;
}

// Where along the way down each order lies; none where that would be a comb.
std::vector<io::ChartSpan> orders_down(const Profiles& made, const Profile& at) {
  constexpr std::size_t most_spans = 30;
  std::vector<io::ChartSpan> spans;
  const auto [least, largest] = std::minmax_element(at.thickness_nm.begin(), at.thickness_nm.end());
  // The whole of a film that is the same everywhere is of one order.
  for (const io::ChartSpan& order :
       order_spans(order_thickness_nm(made.film, made.incidence_deg), *least, std::nextafter(*largest, HUGE_VAL))) {
    bool within = false;
    for (std::size_t i = 0; i < made.depths.size(); ++i) {
      const bool here = at.thickness_nm[i] >= order.low && at.thickness_nm[i] < order.high;
      const double middle = made.depths[i] - (i > 0 ? 1.0 / parts : 0);
      if (here && !within) spans.push_back({middle, made.depths.back(), order.label, order.short_label});
      if (!here && within) spans.back().high = middle;
      within = here;
    }
  }
  if (spans.size() > most_spans) spans.clear();
  return spans;
}

// Each colour stands for the heights around its own, half a part to either side.
io::ChartStrip strip(const Profiles& made, const SideColors& side, std::size_t at, const ChartOptions& options) {
  io::ChartStrip strip;
  strip.low = made.depths.front() - 1.0 / parts;
  strip.high = made.depths.back() + 1.0 / parts;
  const Display display = display_of(options);
  for (const color::Xyz& colour : side.colors[at])
    strip.colors.push_back(shown_bytes(colour, side.factors[at], display));
  if (has_orders(made.film, options)) strip.spans = orders_down(made, made.profiles[at]);
  const std::string brightness = factor_text(side.factors[at]);
  const bool timed = made.profiles.size() > 1 || made.profiles[at].time_s > 0;
  strip.label = fmt::format("{}{}{}", name_of(side.side), timed ? " " + after(made.profiles[at].time_s) : "",
                            brightness.empty() ? "" : ", brightness " + brightness);
  return strip;
}

void add_line(io::Chart& chart, const Profiles& made, const std::vector<double>& nm, const std::string& color) {
  io::ChartSeries& line = chart.series.emplace_back();
  line.color = color;
  line.x = made.depths;
  line.y = nm;
}

void add_curves(io::Chart& chart, const Profiles& made) {
  constexpr double thin_px = 1;
  const std::size_t count = made.profiles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Profile& at = made.profiles[i];
    const std::string color = count == 1 ? "#1a1a1a" : io::sequence_color(i, count);
    add_line(chart, made, at.thickness_nm, color);
    if (count > 1) chart.series.back().label = after(at.time_s);
    if (!at.varies) continue;
    for (const std::vector<double>* bound : {&at.least_nm, &at.largest_nm}) {
      add_line(chart, made, *bound, color);
      chart.series.back().dashed = true;
      chart.series.back().width_px = thin_px;
    }
  }
}

io::Chart draw(const Profiles& made, const ChartOptions& options) {
  constexpr std::size_t most_letters = 110;
  io::Chart chart;
  chart.title = "From the top of a bubble to its bottom: " + title_text(made.film);
  chart.subtitle =
      fmt::format("unpolarised light at {}\u00B0, {}", format_number(made.incidence_deg, 6), light_text(options));
  if (options.interference() != optics::Interference::airy)
    chart.subtitle += fmt::format(", interference '{}'", optics::name_of(options.interference()));
  chart.x = {"depth below the top (radii of the bubble; the bottom is at 2)", made.depths.front(), made.depths.back()};
  chart.y = {"thickness d (nm)", 0, {}};
  chart.width_px = width_px;
  for (const SideColors& side : made.sides)
    for (std::size_t i = 0; i < made.profiles.size(); ++i) chart.strips.push_back(strip(made, side, i, options));
  chart.strip_height_px = chart.strips.size() <= 2 ? single_strip_px : strip_px;
  constexpr int around_strip_px = 48;
  chart.height_px = plot_px + static_cast<int>(chart.strips.size()) * (chart.strip_height_px + around_strip_px);
  add_curves(chart, made);
  const auto is_none = [](const io::ChartSeries& line) { return *std::max_element(line.y.begin(), line.y.end()) <= 0; };
  if (std::all_of(chart.series.begin(), chart.series.end(), is_none)) chart.y.high = 1;
  chart.notes = made.notes;
  chart.notes.push_back("Thickness: " + printable(options.model.value_or(default_profile_model), most_letters));
  if (std::any_of(made.profiles.begin(), made.profiles.end(), [](const Profile& at) { return at.varies; }))
    chart.notes.push_back(
        "Colours and solid lines: the meridian that faces +z. Dashed: least and largest thickness all around.");
  if (std::any_of(chart.strips.begin(), chart.strips.end(),
                  [](const io::ChartStrip& strip) { return !strip.spans.empty(); }))
    chart.notes.push_back(
        "Orders: path difference 2 n d cos \u03B8 in the film, in steps of 550 nm, with n at 550 nm.");
  chart.notes.push_back(display_note(options));
  return chart;
}

std::string table(const Profiles& made, const ChartOptions& options) {
  std::string csv =
      "# A film from the top of a bubble to its bottom: " + printable(options.model.value_or(default_profile_model)) +
      "\n";
  csv +=
      fmt::format("# stack {}; unpolarised light at {} degrees; interference '{}'\n", printable(made.film.expression),
                  format_number(made.incidence_deg), optics::name_of(options.interference()));
  csv += fmt::format(
      "# height: above the centre, in radii; thickness_nm: of layer {} along the meridian that faces +z, whose "
      "colours\n"
      "# follow; least_nm, mean_nm, largest_nm: of {} longitudes\n",
      made.film.layer + 1, longitudes);
  for (const std::string& note : made.notes) csv += "# " + note + "\n";
  csv += color_comments(options, film_sums) +
         "side,time_s,polar_angle_deg,height,thickness_nm,least_nm,mean_nm,largest_nm," + std::string(color_columns) +
         "\n";
  const Display display = display_of(options);
  for (const SideColors& side : made.sides)
    for (std::size_t t = 0; t < made.profiles.size(); ++t) {
      const Profile& at = made.profiles[t];
      for (std::size_t i = 0; i < made.depths.size(); ++i) {
        const double height = 1 - made.depths[i], polar_deg = std::acos(height) * 180 / std::numbers::pi;
        csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", name_of(side.side), format_number(at.time_s),
                           format_number(polar_deg), format_number(height), format_exact(at.thickness_nm[i]),
                           format_exact(at.least_nm[i]), format_exact(at.mean_nm[i]), format_exact(at.largest_nm[i]),
                           color_cells(side.colors[t][i], side.factors[t], display));
      }
    }
  return csv;
}

}  // namespace

std::vector<std::filesystem::path> profile_files(const ChartOptions& options) {
  std::vector<std::filesystem::path> files;
  scene::Resources resources;
  resources.texture = [&files](const std::string& file) -> Result<scene::TextureFile> {
    files.emplace_back(file);
    return scene::TextureFile{{2, 12, 1, std::vector<float>(24)}, false, 0, 0};
  };
  (void)scene::read_thickness(options.model.value_or(default_profile_model), "", options.times_s, resources).ok();
  return files;
}

Result<MadeChart> make_profile_chart(const ChartOptions& options) {
  Result<Profiles> made = compute(options);
  if (!made) return made.errors();
  MadeChart chart;
  if (options.wants_drawing) chart.drawing = draw(*made, options);
  if (options.wants_table) chart.csv = table(*made, options);
  chart.warnings = film_warnings(made->film, made->notes);
  chart.warnings.insert(chart.warnings.begin(), made->warnings.begin(), made->warnings.end());
  return chart;
}

}  // namespace shabon::app
