#include "color_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/io/svg_card.h"

namespace shabon::app {

namespace {

const char* name_of(desk::Side side) { return side == desk::Side::reflected ? "reflected" : "transmitted"; }

std::string conditions(const ColorReport& report) {
  std::string text = fmt::format("unpolarised, {}, lamp {}, observer {}", optics::name_of(report.interference),
                                 report.lamp, report.observer);
  if (report.reversed) text += ", light from the other side";
  if (report.options.adaptation) text += fmt::format(", adapted by {}", color::name_of(*report.options.adaptation));
  return text;
}

const color::ColorSpaceEntry& entry_of(color::ColorSpace space) {
  return color::color_spaces()[static_cast<std::size_t>(space)];
}

// "Display P3 R" as the name of a column: Display_P3_R. Names of columns ignore case, so the two y of xyY are told
// apart by their number: xyY_y2, xyY_Y3.
std::string column_name(const color::ColorSpaceEntry& entry, std::size_t index) {
  const std::string_view component = entry.components[index];
  std::string name = fmt::format("{}_{}", entry.name, component);
  if (std::count_if(entry.components.begin(), entry.components.end(),
                    [&](std::string_view other) { return same_name(other, component); }) > 1)
    name += std::to_string(index + 1);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

JsonObject spaces_json(const ColorReport& report, const FilmColor& film) {
  JsonObject json;
  for (std::size_t i = 0; i < report.spaces.size(); ++i) {
    JsonObject space;
    space.add("values", film.in_spaces[i]);
    if (color::is_encoded(report.spaces[i])) space.add("encoded", color::encoded(report.spaces[i], film.in_spaces[i]));
    json.add_json(entry_of(report.spaces[i]).name, space.line());
  }
  return json;
}

void add_color(JsonObject& json, const ColorReport& report, const FilmColor& film) {
  const desk::Color& c = film.color;
  json.add("XYZ", {c.xyz.x, c.xyz.y, c.xyz.z}).add("xy", {c.xy.x, c.xy.y}).add("Lab", {c.lab.L, c.lab.a, c.lab.b});
  json.add("linear_srgb", {c.linear_srgb.r, c.linear_srgb.g, c.linear_srgb.b});
  json.add("srgb", {c.srgb.r, c.srgb.g, c.srgb.b}).add("hex", color::to_hex(c.srgb));
  json.add("srgb_mapped", {c.srgb_mapped.r, c.srgb_mapped.g, c.srgb_mapped.b});
  json.add("hex_mapped", color::to_hex(c.srgb_mapped)).add("in_gamut", c.in_gamut);
  if (!report.spaces.empty()) json.add_json("spaces", spaces_json(report, film).line());
}

}  // namespace

std::string color_json(const ColorReport& report) {
  JsonObject json;
  if (report.colors.size() == 1) {
    add_color(json, report, report.colors.front());
    return json.text();
  }
  json.add("stack", report.expression).add("interference", optics::name_of(report.interference));
  json.add("illuminant", report.lamp).add("observer", report.observer);
  std::string list;
  for (const FilmColor& film : report.colors) {
    JsonObject item;
    item.add("angle_deg", film.incidence_deg).add("side", name_of(film.side));
    add_color(item, report, film);
    list += (list.empty() ? "\n    " : ",\n    ") + item.line();
  }
  return json.add_json("colors", "[" + list + "\n  ]").text();
}

std::string color_csv(const ColorReport& report) {
  std::string csv =
      "angle_deg,side,X,Y,Z,chromaticity_x,chromaticity_y,L,a,b,linear_r,linear_g,linear_b,srgb_r,srgb_g,srgb_b,hex,"
      "mapped_r,mapped_g,mapped_b,hex_mapped,in_gamut";
  for (const color::ColorSpace space : report.spaces)
    for (std::size_t i = 0; i < 3; ++i) csv += "," + column_name(entry_of(space), i);
  csv += '\n';
  for (const FilmColor& film : report.colors) {
    const desk::Color& c = film.color;
    csv += format_number(film.incidence_deg) + "," + name_of(film.side);
    for (const double value : {c.xyz.x, c.xyz.y, c.xyz.z, c.xy.x, c.xy.y, c.lab.L, c.lab.a, c.lab.b, c.linear_srgb.r,
                               c.linear_srgb.g, c.linear_srgb.b, c.srgb.r, c.srgb.g, c.srgb.b})
      csv += "," + format_exact(value);
    csv += "," + color::to_hex(c.srgb);
    for (const double value : {c.srgb_mapped.r, c.srgb_mapped.g, c.srgb_mapped.b}) csv += "," + format_exact(value);
    csv += "," + color::to_hex(c.srgb_mapped) + (c.in_gamut ? ",true" : ",false");
    for (const std::array<double, 3>& values : film.in_spaces)
      for (const double value : values) csv += "," + format_exact(value);
    csv += '\n';
  }
  return csv;
}

std::string color_svg(const ColorReport& report) {
  io::ColorCard card;
  card.title = report.expression;
  card.subtitle = conditions(report);
  bool mapped = false;
  for (const FilmColor& film : report.colors) {
    const desk::Color& c = film.color;
    io::CardPatch& patch = card.patches.emplace_back();
    patch.heading = fmt::format("{}, {}\u00B0", name_of(film.side), format_number(film.incidence_deg));
    patch.color = color::to_bytes(c.srgb_mapped);
    patch.lines.push_back(fmt::format("sRGB {}{}", color::to_hex(c.srgb_mapped), c.in_gamut ? "" : " (mapped)"));
    patch.lines.push_back(
        fmt::format("linear {:.4f} {:.4f} {:.4f}", c.linear_srgb.r, c.linear_srgb.g, c.linear_srgb.b));
    patch.lines.push_back(fmt::format("XYZ {:.5f} {:.5f} {:.5f}", c.xyz.x, c.xyz.y, c.xyz.z));
    patch.lines.push_back(fmt::format("xy {:.5f} {:.5f}", c.xy.x, c.xy.y));
    patch.lines.push_back(fmt::format("Lab {:.2f} {:.2f} {:.2f}", c.lab.L, c.lab.a, c.lab.b));
    for (std::size_t i = 0; i < report.spaces.size(); ++i) {
      const auto& v = film.in_spaces[i];
      patch.lines.push_back(fmt::format("{} {:.5g} {:.5g} {:.5g}", entry_of(report.spaces[i]).name, v[0], v[1], v[2]));
    }
    mapped = mapped || !c.in_gamut;
  }
  if (mapped)
    card.notes.push_back(
        fmt::format("(mapped): outside sRGB, brought inside by '{}'", color::name_of(report.options.mapping)));
  return io::card_svg(card);
}

}  // namespace shabon::app
