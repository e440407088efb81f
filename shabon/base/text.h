// Text: numbers to and from text without a locale, names that ignore case, the nearest known name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shabon {

std::string_view trim(std::string_view text);
std::string lower(std::string_view text);  // ASCII letters only
bool same_name(std::string_view a, std::string_view b);
std::vector<std::string_view> split(std::string_view text, char separator);

// The whole text as a finite decimal number: optional sign, digits with at most one point, optional exponent. "nan",
// "inf", hexadecimal and trailing characters give nothing; so does a number too large for a double.
std::optional<double> parse_number(std::string_view text);
std::optional<long long> parse_integer(std::string_view text);

std::string format_number(double value);              // shortest text that reads back as the same double
std::string format_number(double value, int digits);  // at most `digits` significant digits
std::string format_exact(double value);               // 17 significant digits

// Text made safe to print: control characters become '?', and it is cut at `most` characters.
std::string printable(std::string_view text, std::size_t most = 400);

// The characters of a UTF-8 text; a byte that is not valid UTF-8 is a character of its own.
std::vector<std::string> utf8_characters(std::string_view text);

// The name nearest to `given` in edit distance, ignoring case, when it is near enough to be a slip of the hand.
std::optional<std::string> nearest_name(std::string_view given, std::span<const std::string_view> names);

// "unknown medium 'watr'; did you mean 'water'?"
std::string unknown_name(std::string_view what, std::string_view given, std::span<const std::string_view> names);

}  // namespace shabon
