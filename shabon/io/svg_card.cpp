#include "shabon/io/svg_card.h"

#include <algorithm>

#include "shabon/io/svg_elements.h"

namespace shabon::io {

namespace {

constexpr std::size_t most_columns = 3;
constexpr double margin_px = 24, patch_width_px = 300, patch_height_px = 130, gap_px = 20;
constexpr double title_px = 16, text_px = 13, note_px = 12, line_px = 18;

std::string hex(const Rgb8& color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t byte : color) (text += digits[byte >> 4]) += digits[byte & 15];
  return text;
}

// Wider text is set smaller, down to half the size.
double fitting_size(std::string_view content, double size, double width) {
  return std::clamp(size * width / std::max(svg::text_width(content, size), 1.0), size / 2, size);
}

std::string text_at(double x, double y, std::string_view content, double size, double width, bool bold = false) {
  svg::TextStyle style;
  style.size = fitting_size(content, size, width);
  style.bold = bold;
  return svg::text(x, y, content, style);
}

std::string drawn(const CardPatch& patch, double left, double top) {
  const svg::Box box{left, top + line_px, left + patch_width_px, top + line_px + patch_height_px};
  std::string svg = text_at(left, top + text_px, patch.heading, text_px, patch_width_px, true);
  svg += svg::rectangle(box, hex(patch.color)) + svg::outline(box);
  double y = box.bottom + line_px;
  for (const std::string& line : patch.lines) {
    svg += text_at(left, y, line, text_px, patch_width_px);
    y += line_px;
  }
  return svg;
}

}  // namespace

std::string card_svg(const ColorCard& card) {
  const std::size_t count = card.patches.size(), columns = std::clamp<std::size_t>(count, 1, most_columns);
  std::size_t lines = 0;
  for (const CardPatch& patch : card.patches) lines = std::max(lines, patch.lines.size());
  const double patch_px = line_px + patch_height_px + static_cast<double>(lines) * line_px + gap_px;
  const std::size_t full_rows = (count + columns - 1) / columns;
  const auto rows = static_cast<double>(full_rows);
  const double width = 2 * margin_px + static_cast<double>(columns) * (patch_width_px + gap_px) - gap_px;
  const double head = margin_px + 2 * line_px + gap_px / 2;
  const double height = head + rows * patch_px + static_cast<double>(card.notes.size()) * line_px + margin_px;

  std::string svg = svg::opening(static_cast<int>(width), static_cast<int>(height));
  const double text_width = width - 2 * margin_px;
  svg += text_at(margin_px, margin_px + title_px / 2, card.title, title_px, text_width, true);
  svg += text_at(margin_px, margin_px + title_px / 2 + line_px, card.subtitle, text_px, text_width);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i / columns, column = i % columns;
    svg += drawn(card.patches[i], margin_px + static_cast<double>(column) * (patch_width_px + gap_px),
                 head + static_cast<double>(row) * patch_px);
  }
  double y = head + rows * patch_px + note_px;
  for (const std::string& note : card.notes) {
    svg += text_at(margin_px, y, note, note_px, text_width);
    y += line_px;
  }
  return svg + "</svg>\n";
}

}  // namespace shabon::io
