#include "shabon/io/svg_elements.h"

#include <cmath>

#include "shabon/base/text.h"
#include "shabon/io/image.h"

namespace shabon::io::svg {

namespace {

// DejaVu Sans where it is installed, so that PNG made elsewhere look alike; Verdana has nearly the same widths.
constexpr std::string_view fonts = "'DejaVu Sans', Verdana, Helvetica, Arial, sans-serif";
constexpr double letter_width = 0.6;  // of the text size, an average over Latin letters and digits in DejaVu Sans

std::string escape(std::string_view content) {
  std::string safe;
  for (const std::string& character : utf8_characters(content)) {
    if (character == "&") {
      safe += "&amp;";
    } else if (character == "<") {
      safe += "&lt;";
    } else if (character == ">") {
      safe += "&gt;";
    } else if (character == "\"") {
      safe += "&quot;";
    } else {
      safe += printable(character);
    }
  }
  return safe;
}

// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  encoded.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(bytes.size() - i, 3);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8 | (j < left ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) encoded += j <= left ? alphabet[group >> (18 - 6 * j) & 63] : '=';
  }
  return encoded;
}

}  // namespace

std::string px(double value) { return format_number(std::round(value * 100) / 100 + 0.0); }

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escape(value) + "\"";
}

std::string text(double x, double y, std::string_view content, const TextStyle& style) {
  std::string element = "<text";
  if (style.turn_deg == 0) {
    element += attribute("x", px(x)) + attribute("y", px(y));
  } else {
    element += attribute("transform", "translate(" + px(x) + " " + px(y) + ") rotate(" + px(style.turn_deg) + ")");
  }
  element += attribute("font-size", px(style.size)) + attribute("text-anchor", style.anchor);
  if (!style.fill.empty()) element += attribute("fill", style.fill);
  if (style.bold) element += attribute("font-weight", "bold");
  return element + ">" + escape(content) + "</text>\n";
}

double text_width(std::string_view content, double size) {
  return letter_width * size * static_cast<double>(utf8_characters(content).size());
}

std::string line(double x1, double y1, double x2, double y2, std::string_view stroke, double width,
                 std::string_view more) {
  return "<line" + attribute("x1", px(x1)) + attribute("y1", px(y1)) + attribute("x2", px(x2)) +
         attribute("y2", px(y2)) + attribute("stroke", stroke) + attribute("stroke-width", px(width)) +
         std::string(more) + "/>\n";
}

std::string box_attributes(const Box& box) {
  return attribute("x", px(box.left)) + attribute("y", px(box.top)) + attribute("width", px(box.width())) +
         attribute("height", px(box.height()));
}

std::string rectangle(const Box& box, std::string_view fill, std::string_view more) {
  return "<rect" + box_attributes(box) + attribute("fill", fill) + std::string(more) + "/>\n";
}

std::string outline(const Box& box) { return rectangle(box, "none", attribute("stroke", "#333333")); }

std::string picture(const Box& box, int columns, int rows, std::span<const std::uint8_t> rgb) {
  const Result<std::string> png = encode_png(columns, rows, rgb, {});
  if (!png) return {};
  // The attribute is what SVG 1.1 knows; today's viewers go by the style.
  return "<image" + box_attributes(box) + attribute("preserveAspectRatio", "none") +
         attribute("image-rendering", "optimizeSpeed") + attribute("style", "image-rendering: pixelated") +
         attribute("xlink:href", "data:image/png;base64," + base64(*png)) + "/>\n";
}

std::string clipped(const Box& box, std::string_view id, std::string_view content) {
  return "<clipPath" + attribute("id", id) + "><rect" + box_attributes(box) + "/></clipPath>\n<g" +
         attribute("clip-path", "url(#" + std::string(id) + ")") + ">\n" + std::string(content) + "</g>\n";
}

std::string opening(int width, int height) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\"" +
         attribute("width", w) + attribute("height", h) + attribute("viewBox", "0 0 " + w + " " + h) +
         attribute("font-family", fonts) + " fill=\"#1a1a1a\" stroke=\"none\">\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

}  // namespace shabon::io::svg
