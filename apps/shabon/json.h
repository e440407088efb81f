// JSON text: objects whose keys keep their order, numbers with the 17 digits that read back as the same double.
#pragma once

#include <concepts>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::app {

// A quoted string. Bytes that are not valid UTF-8 become U+FFFD.
std::string json_string(std::string_view text);
// JSON knows no NaN and no infinity: they become null.
std::string json_number(double value);
std::string json_numbers(std::span<const double> values);
std::string json_numbers(std::initializer_list<double> values);

class JsonObject {
 public:
  // `json` is JSON text: a number, an array, another object.
  JsonObject& add_json(std::string_view key, std::string_view json);
  JsonObject& add(std::string_view key, double value) { return add_json(key, json_number(value)); }
  JsonObject& add(std::string_view key, std::span<const double> values) { return add_json(key, json_numbers(values)); }
  JsonObject& add(std::string_view key, std::initializer_list<double> values) {
    return add_json(key, json_numbers(values));
  }
  JsonObject& add(std::string_view key, std::string_view text) { return add_json(key, json_string(text)); }
  JsonObject& add(std::string_view key, const char* text) { return add_json(key, json_string(text)); }
  JsonObject& add(std::string_view key, std::same_as<bool> auto value) {
    return add_json(key, value ? "true" : "false");
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) JsonObject& add(std::string_view key, Integer value) {
    return add_json(key, std::to_string(value));
  }

  std::string text() const;  // one key a line, with a final newline
  std::string line() const;  // the whole object on one line

 private:
  std::string joined(std::string_view before, std::string_view between, std::string_view after) const;
  std::vector<std::string> members_;
};

}  // namespace shabon::app
