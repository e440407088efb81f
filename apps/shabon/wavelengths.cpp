#include "wavelengths.h"

#include <fmt/format.h>

#include <cmath>

#include "options.h"

namespace shabon::app {

namespace {

// A share of a step that rounding may lack at the end of a grid: 380:380.3:0.1 has four wavelengths.
constexpr double step_slack = 1e-6;

std::vector<double> grid(const std::string& option, const std::vector<std::string_view>& parts, Range range) {
  if (parts.size() != 3)
    usage_error(option, fmt::format("expected A:B:STEP or L1,L2,..., got {} numbers", parts.size()));
  const double first = number_in(option, parts[0], range, "nm"), last = number_in(option, parts[1], range, "nm");
  const double step = number_in(option, parts[2], {.low = 0, .low_open = true}, "nm");
  if (last < first) usage_error(option, fmt::format("expected A:B:STEP with A <= B, got {}:{}", parts[0], parts[1]));
  const double steps = std::floor((last - first) / step + step_slack);
  if (!(steps < static_cast<double>(most_wavelengths)))
    usage_error(option, fmt::format("expected at most {} wavelengths", most_wavelengths));
  std::vector<double> wavelengths_nm;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i)
    wavelengths_nm.push_back(std::min(first + static_cast<double>(i) * step, last));
  return wavelengths_nm;
}

}  // namespace

std::vector<double> wavelengths_in(const std::string& option, const std::string& text, Range range) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() > 1) return grid(option, parts, range);
  return numbers_in(option, {text}, range, "nm", most_wavelengths);
}

void add_wavelengths(CLI::App& app, std::vector<double>& target, const std::string& default_text, Range range) {
  const std::string option = "--wavelengths";
  target = wavelengths_in(option, default_text, range);
  const auto read = [&target, option, range](const std::string& text) { target = wavelengths_in(option, text, range); };
  app.add_option_function<std::string>(option, read,
                                       "Vacuum wavelengths in nm: A:B:STEP or L1,L2,... [" + default_text + "]")
      ->type_name("LIST");
}

}  // namespace shabon::app
