#include "swatch.h"

#include <fmt/format.h>

#include <cstdlib>

#include "streams.h"

namespace shabon::app {

namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool swatch_wanted() { return !is_set("NO_COLOR") && (is_terminal_output() || is_set("CLICOLOR_FORCE")); }

std::string swatch(color::EncodedRgb colour) {
  const auto bytes = color::to_bytes(colour);
  return fmt::format("  \x1b[48;2;{};{};{}m        \x1b[0m", bytes[0], bytes[1], bytes[2]);
}

}  // namespace shabon::app
