#include "shabon/optics/stack_element.h"

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <utility>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

using Unit = StackElementParser::Unit;
constexpr std::array<Unit, 6> units = {{
    {"nm", 1}, {"um", 1e3}, {"\u00B5m", 1e3}, {"\u03BCm", 1e3}, {"mm", 1e6}, {"cm", 1e7},  // micro sign, Greek mu
}};
constexpr std::string_view incoherent_word = "incoherent";
constexpr std::string_view unit_names = "nm, um, \u00B5m, mm or cm";

const Unit* find_unit(std::string_view name) {
  for (const Unit& unit : units)
    if (unit.name == name) return &unit;
  return nullptr;
}

std::string text_of(std::string_view view) { return std::string(view); }

}  // namespace

bool is_length_unit(std::string_view name) { return find_unit(name) != nullptr; }

StackElement StackElementParser::parse() {
  StackElement element;
  element.begin = reader_.offset();
  element.medium = parse_medium();
  element.medium_end = reader_.offset();
  const auto broken = [&] {
    element.broken = true;
    reader_.skip_element();
    return element;
  };
  if (!element.medium && !reader_.at_delimiter()) return broken();
  reader_.skip_space();
  if (at_thickness()) {
    element.thickness_begin = reader_.offset();
    if (!parse_thickness(element)) return broken();
    reader_.skip_space();
    const std::size_t word_begin = reader_.offset();
    if (reader_.at_letter()) {
      const std::string_view word = reader_.take_until_delimiter();
      element.coherent = !same_name(word, incoherent_word);
      if (element.coherent) {
        const bool slip = nearest_name(word, std::array{incoherent_word}).has_value();
        reader_.expected("'|' or 'incoherent'", word_begin, slip ? "; did you mean 'incoherent'?" : "");
        return broken();
      }
    }
  } else if (!reader_.at_end() && !reader_.at('|') && !reader_.at('(') && !reader_.at(')')) {
    if (element.medium) reader_.expected(text_of(thickness_form), reader_.offset());
    return broken();
  }
  element.broken = !element.medium;
  return element;
}

std::optional<Medium> StackElementParser::parse_medium() {
  if (reader_.at_number()) return parse_index();
  if (reader_.at_letter()) return parse_name();
  if (reader_.at('"')) {
    reader_.problem(reader_.offset(), "expected file: before a quoted path");
    return {};
  }
  reader_.expected(text_of(medium_forms), reader_.offset());
  return {};
}

std::optional<Medium> StackElementParser::parse_name() {
  const std::size_t begin = reader_.offset();
  while (!reader_.at_delimiter() && !reader_.at(':') && !reader_.at('"')) reader_.advance();
  if (reader_.at(':') && same_name(reader_.from(begin), "file")) {
    reader_.advance();
    return parse_file();
  }
  reader_.take_until_delimiter();
  const std::string_view name = reader_.from(begin);
  if (same_name(name, "mix")) {
    const std::size_t end = reader_.offset();
    reader_.skip_space();
    if (reader_.at('(')) return parse_mixture(begin);
    reader_.go_to(end);
  }
  if (same_name(name, incoherent_word)) {
    reader_.expected(text_of(medium_forms) + " and a thickness before 'incoherent'", begin);
    return {};
  }
  for (std::string_view word : {"nan", "inf", "infinity"}) {
    if (!same_name(name, word)) continue;
    reader_.expected("a finite index", begin);
    return {};
  }
  return resolve(name, false, begin);
}

// After "file:".
std::optional<Medium> StackElementParser::parse_file() {
  const std::size_t begin = reader_.offset();
  std::string_view path;
  if (reader_.at('"')) {
    reader_.advance();
    bool closed = false;
    path = reader_.take_through('"', closed);
    if (!closed) {
      reader_.problem(begin, "expected '\"' to close the path that starts here");
      reader_.stop();
      return {};
    }
    if (!reader_.at_delimiter()) {
      reader_.expected("white space or '|' after the path", reader_.offset());
      return {};
    }
  } else {
    // A thickness or a bar follows, so '(', ')' and '^' may be part of the path.
    while (!reader_.at_delimiter() || reader_.at('(') || reader_.at(')') || reader_.at('^')) reader_.advance();
    path = reader_.from(begin);
  }
  if (path.empty()) {
    reader_.expected("a path after file:", begin);
    return {};
  }
  return resolve(path, true, begin);
}

std::optional<Medium> StackElementParser::resolve(std::string_view name, bool is_file, std::size_t offset) {
  auto [entry, is_new] = resolved_.try_emplace({is_file, text_of(name)});
  if (!is_new) return entry->second;
  const auto medium = resolver_ ? resolver_(name, is_file) : resolve_from_library(name, is_file);
  if (medium.ok())
    entry->second = medium.value();
  else
    reader_.problems(offset, medium.errors());
  return entry->second;
}

bool StackElementParser::at_thickness() const { return reader_.at_number() || (unknowns_allowed_ && reader_.at('?')); }

// 300nm; where they are allowed also ? and 100..900nm.
bool StackElementParser::parse_thickness(StackElement& element) {
  const std::size_t begin = reader_.offset();
  if (reader_.at('?')) {
    reader_.advance();
    element.unknown = UnknownThickness{begin, {}, {}};
    return true;
  }
  const std::string_view digits = reader_.take_number();
  const auto value = digits.empty() ? std::nullopt : parse_number(digits);
  if (!value) {
    reader_.expected(digits.empty() ? text_of(thickness_form) : "a finite thickness", begin);
    return false;
  }
  const std::size_t digits_end = reader_.offset();
  reader_.skip_space();
  if (unknowns_allowed_ && reader_.at('.')) return parse_range(element, *value, begin);
  reader_.go_to(digits_end);
  const Unit* unit = parse_unit(digits);
  if (!unit) return false;
  element.thickness_nm = *value * unit->nm + 0.0;  // no negative zero
  return check_thickness(element.thickness_nm, begin);
}

// What follows the first number of 100..900nm; both have the unit of the second.
bool StackElementParser::parse_range(StackElement& element, double low, std::size_t begin) {
  const std::size_t points = reader_.offset();
  reader_.advance();
  if (!reader_.at('.')) {
    reader_.expected("a range such as 100..900nm", points);
    return false;
  }
  reader_.advance();
  reader_.skip_space();
  const std::size_t high_begin = reader_.offset();
  const std::string_view digits = reader_.take_number();
  const auto high = digits.empty() ? std::nullopt : parse_number(digits);
  if (!high) {
    reader_.expected("the upper end of a range such as 100..900nm", high_begin);
    return false;
  }
  const Unit* unit = parse_unit(digits);
  if (!unit) return false;
  const ThicknessRange range{low * unit->nm + 0.0, *high * unit->nm + 0.0};
  if (!check_thickness(range.low_nm, begin) || !check_thickness(range.high_nm, high_begin)) return false;
  if (!(range.low_nm < range.high_nm)) {
    reader_.problem(high_begin, "expected a range that rises, such as 100..900nm");
    return false;
  }
  element.unknown = UnknownThickness{begin, range, {}};
  return true;
}

// The unit after a number, or nothing after a problem.
const StackElementParser::Unit* StackElementParser::parse_unit(std::string_view digits) {
  reader_.skip_space();
  const std::size_t begin = reader_.offset();
  const Unit* unit = find_unit(reader_.take_letters());
  if (!unit) reader_.expected("a unit of length (" + text_of(unit_names) + ") after " + text_of(digits), begin);
  return unit;
}

bool StackElementParser::check_thickness(double thickness_nm, std::size_t begin) {
  if (thickness_nm < 0) {
    reader_.expected("a thickness >= 0", begin);
    return false;
  }
  if (!(thickness_nm <= largest_thickness_nm)) {
    reader_.expected("a thickness of at most 1 m (" + format_number(largest_thickness_nm, 6) + " nm)", begin);
    return false;
  }
  return true;
}

}  // namespace shabon::optics
