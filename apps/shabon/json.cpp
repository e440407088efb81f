#include "json.h"

#include <cmath>

#include "shabon/base/text.h"

namespace shabon::app {

namespace {

void append_escaped(std::string& json, const std::string& character) {
  static constexpr char digits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(character[0]);
  if (character.size() == 1 && byte >= 0x80)
    json += "\xEF\xBF\xBD";
  else if (byte == '"' || byte == '\\')
    (json += '\\') += character;
  else if (byte == '\n')
    json += "\\n";
  else if (byte == '\t')
    json += "\\t";
  else if (byte < 0x20 || byte == 0x7F)
    ((json += "\\u00") += digits[byte >> 4]) += digits[byte & 15];
  else
    json += character;
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const std::string& character : utf8_characters(text)) append_escaped(json, character);
  return json + "\"";
}

std::string json_number(double value) { return std::isfinite(value) ? format_exact(value) : "null"; }

std::string json_numbers(std::span<const double> values) {
  std::string json = "[";
  for (const double value : values) {
    if (json.size() > 1) json += ", ";
    json += json_number(value);
  }
  return json + "]";
}

std::string json_numbers(std::initializer_list<double> values) {
  return json_numbers(std::span<const double>(values.begin(), values.size()));
}

JsonObject& JsonObject::add_json(std::string_view key, std::string_view json) {
  members_.push_back(json_string(key) + ": " + std::string(json));
  return *this;
}

std::string JsonObject::joined(std::string_view before, std::string_view between, std::string_view after) const {
  std::string json(before);
  for (std::size_t i = 0; i < members_.size(); ++i) (json += i ? between : "") += members_[i];
  return json += after;
}

std::string JsonObject::text() const { return joined("{\n  ", ",\n  ", "\n}\n"); }
std::string JsonObject::line() const { return joined("{", ", ", "}"); }

}  // namespace shabon::app
