#include "options.h"

#include <fmt/format.h>

#include <limits>

namespace shabon::app {

namespace {

std::string range_text(Range range, std::string_view unit) {
  const std::string low = format_number(range.low), high = format_number(range.high);
  const std::string shown_unit = unit.empty() ? "" : " " + std::string(unit);
  const std::string_view above = range.low_open ? "above" : "of at least";
  if (range.has_low() && range.has_high())
    return fmt::format("a number {} {}{} {}{}", range.low_open ? "above" : "from", low, range.low_open ? " and" : "",
                       range.high_open  ? "below "
                       : range.low_open ? "at most "
                                        : "to ",
                       high + shown_unit);
  if (range.has_low()) return fmt::format("a number {} {}{}", above, low, shown_unit);
  return "a number";
}

// The long name, for messages.
std::string shown_name(const std::string& names) {
  for (const std::string& name : CLI::detail::split_names(names))
    if (name.starts_with("--")) return name;
  return names;
}

}  // namespace

std::string meant(std::string_view text, std::span<const std::string_view> words) {
  const std::optional<std::string> near = nearest_name(text, words);
  return fmt::format("'{}'{}", printable(text, 60), near ? "; did you mean '" + *near + "'?" : "");
}

double number_in(const std::string& option, std::string_view text, Range range, std::string_view unit) {
  const std::optional<double> number = parse_number(trim(text));
  if (!number || !range.contains(*number))
    usage_error(option, fmt::format("expected {}, got '{}'", range_text(range, unit), printable(text, 60)));
  return *number;
}

long long integer_in(const std::string& option, std::string_view text, long long least, long long most) {
  const std::optional<long long> number = parse_integer(trim(text));
  if (number && *number >= least && *number <= most) return *number;
  const bool unbounded = most == std::numeric_limits<long long>::max();
  const std::string range =
      unbounded ? fmt::format("of at least {}, below 2^63", least) : fmt::format("from {} to {}", least, most);
  usage_error(option, fmt::format("expected a whole number {}, got '{}'", range, printable(text, 60)));
}

std::vector<double> numbers_in(const std::string& option, const std::vector<std::string>& texts, Range range,
                               std::string_view unit, std::size_t most_values) {
  std::vector<double> numbers;
  for (const std::string& text : texts)
    for (const std::string_view part : split(text, ',')) numbers.push_back(number_in(option, part, range, unit));
  if (numbers.size() > most_values)
    usage_error(option, fmt::format("expected at most {} values, got {}", most_values, numbers.size()));
  return numbers;
}

CLI::Option* add_number(CLI::App& app, const std::string& names, std::optional<double>& target, Range range,
                        std::string_view unit, const std::string& description) {
  const auto read = [&target, range, unit, option = shown_name(names)](const std::string& text) {
    target = number_in(option, text, range, unit);
  };
  return app.add_option_function<std::string>(names, read, description)->type_name("NUMBER");
}

CLI::Option* add_integer(CLI::App& app, const std::string& names, std::optional<long long>& target, long long least,
                         long long most, const std::string& description) {
  const auto read = [&target, least, most, option = shown_name(names)](const std::string& text) {
    target = integer_in(option, text, least, most);
  };
  return app.add_option_function<std::string>(names, read, description)->type_name("N");
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& target,
                      const std::string& value_name, const std::string& description) {
  const auto read = [&target, value_name, option = shown_name(names)](const std::string& text) {
    if (trim(text).empty()) usage_error(option, "expected a value, got an empty text");
    // An option that stands where a value is missing.
    if (text.starts_with("--") && text.size() > 2)
      usage_error(option, fmt::format("expected {}, got the option '{}'", value_name, printable(text, 60)));
    target = text;
  };
  return app.add_option_function<std::string>(names, read, description)->type_name(value_name);
}

CLI::Option* add_texts(CLI::App& app, const std::string& names, std::vector<std::string>& target,
                       const std::string& value_name, const std::string& description) {
  return app.add_option(names, target, description)->type_name(value_name)->allow_extra_args(false);
}

CLI::Option* add_numbers(CLI::App& app, const std::string& names, std::vector<double>& target, Range range,
                         std::string_view unit, std::size_t most_values, const std::string& description) {
  const auto read = [&target, range, unit, most_values,
                     option = shown_name(names)](const std::vector<std::string>& texts) {
    target = numbers_in(option, texts, range, unit, most_values);
  };
  return app.add_option_function<std::vector<std::string>>(names, read, description)
      ->type_name("LIST")
      ->allow_extra_args(false);
}

CLI::Option* add_tuple(CLI::App& app, const std::string& names, std::vector<double>& target, int count,
                       const std::string& value_name, const std::string& description) {
  const auto read = [&target, option = shown_name(names)](const std::vector<std::string>& texts) {
    target = numbers_in(option, texts, Range{}, {}, texts.size());
  };
  return app.add_option_function<std::vector<std::string>>(names, read, description)
      ->type_name(value_name)
      ->expected(count)
      ->allow_extra_args(false);
}

CLI::Option* add_name(CLI::App& app, const std::string& option, std::size_t& target,
                      const std::vector<std::string_view>& names, const std::string& description) {
  const auto choose = [&target, names, option](const std::string& text) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!same_name(names[i], text)) continue;
      target = i;
      return;
    }
    usage_error(option, unknown_name("value", text, names));
  };
  const std::string help = fmt::format("{}: {} [{}]", description, fmt::join(names, ", "), names[target]);
  return app.add_option_function<std::string>(option, choose, help)->type_name("NAME");
}

}  // namespace shabon::app
