#include "thickness_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "shabon/base/text.h"
#include "shabon/color/lab.h"
#include "shabon/color/rgb.h"

namespace shabon::app {

namespace {

constexpr double most_byte = 255;

Diagnostics refuse(std::string_view text, const std::string& expected) {
  return fail(Failure::usage, fmt::format("--color: expected {}, got '{}'", expected, printable(text, 60)));
}

std::optional<std::array<int, 3>> bytes_of(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return {};
  const std::size_t width = digits.size() / 3;
  std::array<int, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::string pair(digits.substr(i * width, width));
    if (width == 1) pair += pair;
    const auto [end, error] = std::from_chars(pair.data(), pair.data() + pair.size(), bytes[i], 16);
    if (error != std::errc() || end != pair.data() + pair.size()) return {};
  }
  return bytes;
}

color::Xyz xyz_of(const std::array<double, 3>& bytes) {
  return color::linear_srgb_to_xyz(
      color::decode_srgb(color::EncodedRgb{bytes[0] / most_byte, bytes[1] / most_byte, bytes[2] / most_byte}));
}

Result<ToldColor> told_components(std::string_view text, std::size_t colon, color::Xyz white) {
  const std::string_view name = trim(text.substr(0, colon));
  ToldColor told{std::string(text), {}, {}};
  if (const auto space = color::find_color_space(name)) {
    told.space = *space;
  } else {
    std::vector<std::string_view> names;
    for (const color::ColorSpaceEntry& entry : color::color_spaces()) names.push_back(entry.name);
    return fail(Failure::usage, "--color: " + unknown_name("colour space", name, names));
  }
  std::vector<double> values;
  for (const std::string_view part : split(text.substr(colon + 1), ',')) {
    const std::optional<double> value = parse_number(trim(part));
    if (!value) return refuse(text, "numbers after the colour space");
    values.push_back(*value);
  }
  if (values.size() != 3) return refuse(text, "three numbers after the colour space");
  told.xyz = color::to_xyz(told.space, {values[0], values[1], values[2]}, white);
  return told;
}

}  // namespace

Result<ToldColor> told_color(std::string_view text, color::Xyz white) {
  const std::string_view trimmed = trim(text);
  if (const std::size_t colon = trimmed.find(':'); colon != std::string_view::npos)
    return told_components(trimmed, colon, white);
  const auto bytes = bytes_of(trimmed.starts_with("#") ? trimmed.substr(1) : trimmed);
  if (!bytes) return refuse(text, "#rrggbb or SPACE:A,B,C such as Lab:60,20,-30");
  ToldColor told{std::string(trimmed), color::ColorSpace::sRGB, {}, true};
  const std::array<double, 3> values{double((*bytes)[0]), double((*bytes)[1]), double((*bytes)[2])};
  told.xyz = xyz_of(values);
  told.text = color::to_hex({values[0] / most_byte, values[1] / most_byte, values[2] / most_byte});
  told.at_the_end = std::any_of(values.begin(), values.end(), [](double b) { return b == 0 || b == most_byte; });
  return told;
}

double rounding_difference(const ToldColor& told, color::Xyz white) {
  if (!told.is_bytes) return 0;
  const auto bytes = bytes_of(std::string_view(told.text).substr(1));
  const color::Lab lab = color::xyz_to_lab(told.xyz, white);
  double most = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
      values[i] = std::clamp((*bytes)[i] + (corner >> i & 1 ? 0.5 : -0.5), 0.0, most_byte);
    most = std::max(most, color::ciede2000(lab, color::xyz_to_lab(xyz_of(values), white)));
  }
  return most;
}

}  // namespace shabon::app
