// The elements of an SVG drawing as text. Lengths in px, angles in degrees. Inside the room only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace shabon::io::svg {

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

struct TextStyle {
  double size = 13;
  std::string_view anchor = "start";
  std::string_view fill = {};  // empty: that of the drawing
  bool bold = false;
  double turn_deg = 0;  // clockwise, about the place of the text
};

// A number with at most two decimals.
std::string px(double value);

// ` name="value"`, the value made safe: XML forbids control characters and broken UTF-8.
std::string attribute(std::string_view name, std::string_view value);

std::string text(double x, double y, std::string_view content, const TextStyle& style);
// An estimate: the width depends on the font that the reader has.
double text_width(std::string_view content, double size);

std::string line(double x1, double y1, double x2, double y2, std::string_view stroke, double width,
                 std::string_view more = {});
// x, y, width and height of a box.
std::string box_attributes(const Box& box);
std::string rectangle(const Box& box, std::string_view fill, std::string_view more = {});
std::string outline(const Box& box);

// A picture that fills the box, without smoothing where the viewer can. `rgb` as ChartPicture; empty text when the
// sizes do not fit.
std::string picture(const Box& box, int columns, int rows, std::span<const std::uint8_t> rgb);

// Whatever `content` draws outside the box is cut off. Some simple viewers lose what is clipped: only where needed.
std::string clipped(const Box& box, std::string_view id, std::string_view content);

// The begin of a document with a white ground; "</svg>" ends it.
std::string opening(int width, int height);

}  // namespace shabon::io::svg
