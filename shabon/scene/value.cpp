#include "shabon/scene/value.h"

#include <cmath>
#include <limits>
#include <optional>

#include "shabon/base/text.h"

namespace shabon::scene {

namespace {

bool wrong_type(const io::YamlNode& node, const Path& path, const std::string& expected, Problems& problems) {
  problems.add(node, path, "expected " + expected + ", got " + io::describe(node));
  return false;
}

bool is_plain_scalar(const io::YamlNode& node) { return node.kind == io::YamlNode::Kind::scalar && !node.quoted; }

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : number + " " + std::string(unit);
}

std::string with_unit(double number, std::string_view unit) { return with_unit(value_text(number), unit); }

// "expected >= 0 nm, got -120" when `value` leaves the range.
std::optional<std::string> out_of_range(double value, const std::string& got, const FieldInfo& info) {
  if (!std::isfinite(value)) return "expected a finite number, got " + got;
  const Range& range = info.range;
  if (range.low == range.high && value != range.low)
    return "expected " + with_unit(range.low, info.unit) + ", got " + got;
  if (!range.above_low(value))
    return "expected " + std::string(range.low_open ? "> " : ">= ") + with_unit(range.low, info.unit) + ", got " + got;
  if (!range.below_high(value))
    return "expected " + std::string(range.high_open ? "< " : "<= ") + with_unit(range.high, info.unit) + ", got " +
           got;
  return {};
}

// Whole numbers may also be written as 64.0 or 1e3, as some programs write JSON.
std::optional<long long> whole_number(const io::YamlNode& node) {
  if (!is_plain_scalar(node)) return {};
  if (const auto whole = parse_integer(node.text)) return whole;
  const auto number = parse_number(node.text);
  constexpr double largest_exact = 0x1p53;
  if (!number || *number != std::floor(*number) || std::abs(*number) > largest_exact) return {};
  return static_cast<long long>(*number);
}

template <class Whole>
bool read_whole(const io::YamlNode& node, const FieldInfo& info, const Path& path, Whole& value, Problems& problems) {
  const std::optional<long long> whole = whole_number(node);
  if (!whole) return wrong_type(node, path, type_text(Of<Whole>{}, info), problems);
  if (const auto problem = out_of_range(static_cast<double>(*whole), std::to_string(*whole), info)) {
    problems.add(node, path, *problem);
    return false;
  }
  value = static_cast<Whole>(*whole);
  return true;
}

void check_range(double value, const std::string& got, const FieldInfo& info, const Path& path, Problems& problems) {
  if (problems.has(path)) return;
  if (const auto problem = out_of_range(value, got, info)) problems.add(path, *problem);
}

constexpr std::string_view component_names = "xyz";

}  // namespace

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, double& value, Problems& problems) {
  const auto number = is_plain_scalar(node) ? parse_number(node.text) : std::nullopt;
  if (!number) return wrong_type(node, path, type_text(Of<double>{}, info), problems);
  value = *number;
  return true;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, int& value, Problems& problems) {
  return read_whole(node, info, path, value, problems);
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, std::uint64_t& value,
                Problems& problems) {
  return read_whole(node, info, path, value, problems);
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, std::string& value,
                Problems& problems) {
  if (node.kind != io::YamlNode::Kind::scalar)
    return wrong_type(node, path, type_text(Of<std::string>{}, info), problems);
  value = node.text;
  return true;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, math::Vec3d& value,
                Problems& problems) {
  if (node.kind != io::YamlNode::Kind::sequence)
    return wrong_type(node, path, type_text(Of<math::Vec3d>{}, info), problems);
  if (node.items.size() != component_names.size()) {
    problems.add(
        node, path,
        "expected " + type_text(Of<math::Vec3d>{}, info) + ", got " + std::to_string(node.items.size()) + " items");
    return false;
  }
  double components[3] = {};
  bool understood = true;
  for (int i = 0; i < 3; ++i)
    understood &=
        read_value(node.items[static_cast<std::size_t>(i)], info, Path{&path, {}, i}, components[i], problems);
  if (understood) value = {components[0], components[1], components[2]};
  return understood;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, optics::Interference& value,
                Problems& problems) {
  if (node.kind != io::YamlNode::Kind::scalar)
    return wrong_type(node, path, type_text(Of<optics::Interference>{}, info), problems);
  if (const auto found = optics::find_interference(node.text)) {
    value = *found;
    return true;
  }
  std::vector<std::string_view> names;
  for (const optics::InterferenceEntry& entry : optics::interference_models) names.push_back(entry.name);
  problems.add(node, path, unknown_name("interference model", node.text, names));
  return false;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, bool& value, Problems& problems) {
  const bool plain = is_plain_scalar(node);
  if (!plain || (node.text != "true" && node.text != "false"))
    return wrong_type(node, path, type_text(Of<bool>{}, info), problems);
  value = node.text == "true";
  return true;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, Repeat& value, Problems& problems) {
  if (node.kind != io::YamlNode::Kind::sequence || node.items.size() != 2)
    return wrong_type(node, path, type_text(Of<Repeat>{}, info), problems);
  Repeat read;
  const bool u = read_value(node.items[0], info, Path{&path, {}, 0}, read.u, problems);
  const bool v = read_value(node.items[1], info, Path{&path, {}, 1}, read.v, problems);
  if (u && v) value = read;
  return u && v;
}

bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, ColorDesc& value,
                Problems& problems) {
  if (node.kind == io::YamlNode::Kind::sequence) {
    math::Vec3d rgb;
    if (!read_value(node, info, path, rgb, problems)) return false;
    value.value = rgb;
    return true;
  }
  if (node.kind != io::YamlNode::Kind::scalar)
    return wrong_type(node, path, type_text(Of<ColorDesc>{}, info), problems);
  if (const auto number = is_plain_scalar(node) ? parse_number(node.text) : std::nullopt)
    value.value = *number;
  else
    value.value = node.text;
  return true;
}

void check_value(double value, const FieldInfo& info, const Path& path, Problems& problems) {
  check_range(value, value_text(value), info, path, problems);
}

void check_value(int value, const FieldInfo& info, const Path& path, Problems& problems) {
  check_range(value, value_text(value), info, path, problems);
}

void check_value(std::uint64_t value, const FieldInfo& info, const Path& path, Problems& problems) {
  check_range(static_cast<double>(value), value_text(value), info, path, problems);
}

void check_value(const std::string& value, const FieldInfo& info, const Path& path, Problems& problems) {
  if (info.names == nullptr || problems.has(path)) return;
  const std::vector<std::string_view> names = info.names();
  for (std::string_view name : names)
    if (same_name(name, value)) return;
  problems.add(path, unknown_name(path.key, value, names));
}

void check_value(const math::Vec3d& value, const FieldInfo& info, const Path& path, Problems& problems) {
  const double components[3] = {value.x, value.y, value.z};
  for (int i = 0; i < 3; ++i) check_value(components[i], info, Path{&path, {}, i}, problems);
}

void check_value(bool, const FieldInfo&, const Path&, Problems&) {}

void check_value(const Repeat& value, const FieldInfo& info, const Path& path, Problems& problems) {
  check_value(value.u, info, Path{&path, {}, 0}, problems);
  check_value(value.v, info, Path{&path, {}, 1}, problems);
}

void check_value(const ColorDesc& color, const FieldInfo&, const Path& path, Problems& problems) {
  const FieldInfo share{.range = share_range};
  if (const auto* number = std::get_if<double>(&color.value)) return check_value(*number, share, path, problems);
  if (const auto* rgb = std::get_if<math::Vec3d>(&color.value)) return check_value(*rgb, share, path, problems);
  const auto& text = std::get<std::string>(color.value);
  if (problems.has(path) || hex_color(text) || color_file(text)) return;
  problems.add(path, "expected " + type_text(Of<ColorDesc>{}, {}) + ", got '" + printable(text, 60) + "'");
}

void check_value(optics::Interference, const FieldInfo&, const Path&, Problems&) {}

std::string type_text(Of<double>, const FieldInfo&) { return "a number"; }

std::string type_text(Of<int>, const FieldInfo& info) {
  const bool only_one = info.range.low == info.range.high;
  return only_one ? with_unit(info.range.low, info.unit) : "a whole number";
}

std::string type_text(Of<std::uint64_t>, const FieldInfo&) { return "a whole number below 2^63"; }
std::string type_text(Of<std::string>, const FieldInfo&) { return "text"; }
std::string type_text(Of<math::Vec3d>, const FieldInfo&) { return "three numbers [x, y, z]"; }

std::string type_text(Of<bool>, const FieldInfo&) { return "true or false"; }
std::string type_text(Of<Repeat>, const FieldInfo&) { return "two numbers [u, v]"; }
std::string type_text(Of<ColorDesc>, const FieldInfo&) {
  return "a colour: '#rrggbb' in quotes, [r, g, b], a number 0..1 or file:PATH";
}

std::string type_text(Of<optics::Interference>, const FieldInfo&) {
  std::string text;
  for (const optics::InterferenceEntry& entry : optics::interference_models)
    text += (text.empty() ? "" : ", ") + std::string(entry.name);
  return "one of " + text;
}

std::string value_text(double value) {
  constexpr double longest_whole = 1e9;  // beyond it an exponent reads better
  const bool whole = std::abs(value) <= longest_whole && value == std::floor(value);
  return whole ? std::to_string(static_cast<long long>(value)) : format_number(value);
}
std::string value_text(int value) { return std::to_string(value); }
std::string value_text(std::uint64_t value) { return std::to_string(value); }
std::string value_text(const std::string& value) { return value; }
std::string value_text(optics::Interference value) { return std::string(optics::name_of(value)); }
std::string value_text(bool value) { return value ? "true" : "false"; }
std::string value_text(const Repeat& value) { return "[" + value_text(value.u) + ", " + value_text(value.v) + "]"; }
std::string value_text(const ColorDesc& color) {
  return std::visit([](const auto& chosen) { return value_text(chosen); }, color.value);
}
std::string value_text(const math::Vec3d& v) {
  return "[" + value_text(v.x) + ", " + value_text(v.y) + ", " + value_text(v.z) + "]";
}

std::string range_text(const FieldInfo& info) {
  const Range& range = info.range;
  if (range.low == range.high) return with_unit(range.low, info.unit);
  const std::string low = (range.low_open ? "> " : ">= ") + value_text(range.low);
  const std::string high = (range.high_open ? "< " : "<= ") + value_text(range.high);
  if (range.has_low() && range.has_high()) {
    const bool closed = !range.low_open && !range.high_open;
    const std::string text = closed ? value_text(range.low) + ".." + value_text(range.high) : low + ", " + high;
    return with_unit(text, info.unit);
  }
  return range.has_low() ? with_unit(low, info.unit) : range.has_high() ? with_unit(high, info.unit) : "";
}

}  // namespace shabon::scene
