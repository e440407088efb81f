#include "chart_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "options.h"
#include "shabon/base/text.h"

namespace shabon::app {

namespace {

// A share of a step that rounding may lack at the end of a range.
constexpr double step_slack = 1e-6;

struct Part {
  std::string_view number;
  const RangeUnit* unit = nullptr;
};

Part split_unit(std::string_view text, std::span<const RangeUnit> units) {
  text = trim(text);
  for (const RangeUnit& unit : units)
    if (text.ends_with(unit.name)) return {trim(text.substr(0, text.size() - unit.name.size())), &unit};
  return {text, nullptr};
}

// "nm, um, mm or cm"
std::string names_of(std::span<const RangeUnit> units) {
  std::vector<std::string_view> names;
  for (const RangeUnit& unit : units)
    if (std::all_of(unit.name.begin(), unit.name.end(), [](char c) { return c > 0; })) names.push_back(unit.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 < names.size() ? ", " : " or ", names[i]);
  return text;
}

}  // namespace

double ChartRange::step_or(int parts) const {
  if (step) return *step;
  const double most = (high - low) / parts;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double digit = most / power * (1 + step_slack);
  const double round = digit >= 5 ? 5 : digit >= 2 ? 2 : 1;
  // Powers below one have no exact double; twelve digits remove the dust.
  return parse_number(format_number(round * power, 12)).value_or(round * power);
}

std::vector<double> ChartRange::values(double apart) const {
  std::vector<double> all;
  const double steps = std::floor((high - low) / apart + step_slack);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i)
    all.push_back(std::min(low + static_cast<double>(i) * apart, high));
  return all;
}

std::vector<double> ChartAngles::values(const std::vector<double>& usual) const {
  constexpr double usual_step = 10;
  if (range) return range->values(range->step.value_or(usual_step));
  return list.empty() ? usual : list;
}

ChartRange range_in(const std::string& option, std::string_view text, std::span<const RangeUnit> units, Range allowed,
                    std::size_t most) {
  const std::vector<std::string_view> texts = split(text, ':');
  if (texts.size() < 2 || texts.size() > 3)
    usage_error(option, fmt::format("expected A:B or A:B:STEP in {}, got '{}'", units[0].name, printable(text, 60)));
  std::vector<Part> parts;
  for (const std::string_view part : texts) parts.push_back(split_unit(part, units));
  const RangeUnit* usual = parts[1].unit != nullptr ? parts[1].unit : &units[0];
  const auto value = [&](std::size_t i, Range range) {
    const RangeUnit& unit = parts[i].unit != nullptr ? *parts[i].unit : *usual;
    // Twelve digits: 0.3 um are 300 nm.
    if (!parse_number(parts[i].number))
      usage_error(option,
                  fmt::format("expected a number in {}, got '{}'", names_of(units), printable(trim(texts[i]), 60)));
    const double shown = number_in(option, parts[i].number, {}, unit.name);
    const double number = parse_number(format_number(shown * unit.factor, 15)).value_or(shown * unit.factor);
    if (!range.contains(number)) number_in(option, format_number(number), range, units[0].name);
    return number;
  };
  ChartRange range{value(0, allowed), value(1, allowed), {}};
  if (!(range.high > range.low))
    usage_error(option, fmt::format("expected A:B with A < B, got '{}'", printable(text, 60)));
  if (parts.size() == 3) range.step = value(2, {.low = 0, .low_open = true});
  if (range.step && !((range.high - range.low) / *range.step < static_cast<double>(most)))
    usage_error(option, fmt::format("expected at most {} values", most));
  return range;
}

}  // namespace shabon::app
