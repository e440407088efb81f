#include "shabon/scene/color_desc.h"

#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"

namespace shabon::scene {

namespace {

constexpr double largest_byte = 255;

std::optional<int> hex_digit(char c) {
  const std::size_t digit = std::string_view("0123456789abcdef").find(c);
  return digit == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(digit));
}

}  // namespace

std::optional<color::LinearRgb> hex_color(std::string_view text) {
  const std::string digits = lower(trim(text));
  if (digits.size() != 7 || digits.front() != '#') return {};
  double encoded[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto high = hex_digit(digits[2 * i + 1]), low = hex_digit(digits[2 * i + 2]);
    if (!high || !low) return {};
    encoded[i] = (16 * *high + *low) / largest_byte;
  }
  return color::decode_srgb(color::EncodedRgb{encoded[0], encoded[1], encoded[2]});
}

std::optional<std::string> color_file(std::string_view text) {
  auto path = color::illuminant_file(text);  // lamps have the same spelling
  return path && !path->empty() ? path : std::nullopt;
}

}  // namespace shabon::scene
