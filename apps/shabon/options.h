// What every option has in common: one value at a time, numbers read without a locale, problems told in one form.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/base/text.h"

namespace shabon::app {

// Ends the command with exit code 2. `option` is the name as typed, such as "--angle".
[[noreturn]] inline void usage_error(const std::string& option, const std::string& message) {
  throw CLI::ValidationError(option, message);
}

// "'fot'; did you mean 'fit'?", or the text alone: for messages where other things than these words stand too.
std::string meant(std::string_view text, std::span<const std::string_view> words);

// The finite number that `text` is, or a usage error.
double number_in(const std::string& option, std::string_view text, Range range, std::string_view unit = {});
// The largest long long as `most` is no limit of its own and told as "below 2^63".
long long integer_in(const std::string& option, std::string_view text, long long least, long long most);

// "0,30,60": each part by number_in. Several texts are one list. At most `most_values` of them.
std::vector<double> numbers_in(const std::string& option, const std::vector<std::string>& texts, Range range,
                               std::string_view unit, std::size_t most_values);

CLI::Option* add_number(CLI::App& app, const std::string& names, std::optional<double>& target, Range range,
                        std::string_view unit, const std::string& description);
CLI::Option* add_integer(CLI::App& app, const std::string& names, std::optional<long long>& target, long long least,
                         long long most, const std::string& description);

// A text, such as a name or a file. Empty ones are refused, and what looks like an option; a file may
// still be named ./--so.
CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& target,
                      const std::string& value_name, const std::string& description);

// May be given several times, with one value each.
CLI::Option* add_texts(CLI::App& app, const std::string& names, std::vector<std::string>& target,
                       const std::string& value_name, const std::string& description);

// A list of numbers, "0,30,60"; given several times it is one list. `target` holds the default until then.
CLI::Option* add_numbers(CLI::App& app, const std::string& names, std::vector<double>& target, Range range,
                         std::string_view unit, std::size_t most_values, const std::string& description);

// Exactly `count` numbers after the option.
CLI::Option* add_tuple(CLI::App& app, const std::string& names, std::vector<double>& target, int count,
                       const std::string& value_name, const std::string& description);

// One of a closed set of names, ignoring case. `entries` is a list of structs with a `name`; `target` becomes the index
// of the chosen one.
CLI::Option* add_name(CLI::App& app, const std::string& option, std::size_t& target,
                      const std::vector<std::string_view>& names, const std::string& description);

template <class Entries>
CLI::Option* add_choice(CLI::App& app, const std::string& option, std::size_t& target, const Entries& entries,
                        const std::string& description) {
  std::vector<std::string_view> names;
  names.reserve(std::size(entries));
  for (const auto& entry : entries) names.push_back(entry.name);
  return add_name(app, option, target, names, description);
}

}  // namespace shabon::app
