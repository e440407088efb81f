// Radiance pictures (G. Ward, "Real Pixels", Graphics Gems II, 1991; the Radiance Reference Manual's "picture" format).
#include <array>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/io/pixel_sink.h"

namespace shabon::io {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr int exponent_bias = 128 + 8;                             // 8: the mantissas are whole numbers below 256
constexpr int shortest_coded_row = 8, longest_coded_row = 0x7FFF;  // rows outside are never run length coded anew
constexpr std::size_t longest_header_line = 4096;

// Bytes with an end: what lies past it is an error that sticks, not a value.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}
  bool ended() const { return ended_; }
  std::uint8_t next() {
    if (rest_.empty()) {
      ended_ = true;
      return 0;
    }
    const auto byte = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }
  Rgbe next_pixel() {
    Rgbe pixel;
    for (std::uint8_t& byte : pixel) byte = next();
    return pixel;
  }
  // The text up to the line's end, which is taken too; nothing when there is no end within a sensible length.
  std::optional<std::string_view> next_line() {
    const std::size_t end = rest_.substr(0, longest_header_line).find('\n');
    if (end == std::string_view::npos) return {};
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

 private:
  std::string_view rest_;
  bool ended_ = false;
};

struct Header {
  int width = 0, height = 0;
  std::array<double, 3> divisor{1, 1, 1};  // product of the EXPOSURE and COLORCORR lines
};

// Multiplies one EXPOSURE (one number) or COLORCORR (three) into the divisor. False when it is no positive number.
bool apply_exposure(std::string_view numbers, bool three, std::array<double, 3>& divisor) {
  std::vector<std::string_view> parts;
  for (std::string_view part : split(numbers, ' '))
    if (!trim(part).empty()) parts.push_back(trim(part));
  if (parts.size() != (three ? 3u : 1u)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_number(parts[three ? i : 0]);
    if (!value || !(*value > 0)) return false;
    divisor[i] *= *value;
  }
  return std::isfinite(divisor[0] * divisor[1] * divisor[2]);
}

// The error in a line of the header, or nothing.
std::optional<std::string> read_variable(std::string_view line, Header& header) {
  const std::size_t equals = line.find('=');
  if (line.starts_with('#') || equals == std::string_view::npos) return {};  // comments, and programs that made it
  const std::string_view name = trim(line.substr(0, equals)), value = trim(line.substr(equals + 1));
  if (name == "FORMAT" && value != "32-bit_rle_rgbe")
    return "pictures of FORMAT=" + printable(value, 40) + " are not supported; expected 32-bit_rle_rgbe";
  if ((name == "EXPOSURE" || name == "COLORCORR") && !apply_exposure(value, name == "COLORCORR", header.divisor))
    return std::string(name) + ": expected " + (name == "COLORCORR" ? "three numbers" : "one number") + " > 0, got " +
           printable(value, 40);
  return {};
}

std::optional<std::string> read_resolution(std::string_view line, Header& header) {
  std::vector<std::string_view> parts;
  for (std::string_view part : split(line, ' '))
    if (!part.empty()) parts.push_back(part);
  const auto is_axis = [](std::string_view part) {
    return part == "-Y" || part == "+Y" || part == "-X" || part == "+X";
  };
  if (parts.size() != 4 || !is_axis(parts[0]) || !is_axis(parts[2]))
    return "expected a resolution line such as '-Y 512 +X 1024', got '" + printable(line, 60) + "'";
  if (parts[0] != "-Y" || parts[2] != "+X")
    return "orientation '" + std::string(parts[0]) + " " + std::string(parts[2]) +
           "' is not supported; expected '-Y +X'";
  const auto height = parse_integer(parts[1]), width = parse_integer(parts[3]);
  constexpr long long unthinkable = 1'000'000'000;
  if (!height || !width || *height > unthinkable || *width > unthinkable || *height < 0 || *width < 0)
    return "expected a resolution line such as '-Y 512 +X 1024', got '" + printable(line, 60) + "'";
  header.height = static_cast<int>(*height);
  header.width = static_cast<int>(*width);
  return {};
}

Result<Header> read_header(Bytes& bytes, const std::string& source) {
  Header header;
  auto line = bytes.next_line();
  if (!line || !line->starts_with("#?"))
    return picture_error(source, "not a Radiance picture: it must begin with '#?'");
  while ((line = bytes.next_line()) && !line->empty())
    if (const auto error = read_variable(*line, header)) return picture_error(source, *error);
  if (line) line = bytes.next_line();
  if (!line) return picture_error(source, "the picture's header is truncated");
  if (const auto error = read_resolution(*line, header)) return picture_error(source, *error);
  if (const auto error = refuse_size(source, header.width, header.height)) return *error;
  return header;
}

// One component of a row: runs (above 128: that many less 128 of one byte) and literal stretches.
bool read_component(Bytes& bytes, std::vector<Rgbe>& row, std::size_t component) {
  for (std::size_t x = 0; x < row.size();) {
    const std::uint8_t code = bytes.next();
    const bool run = code > 128;
    const std::size_t count = run ? code - 128u : code;
    if (count == 0 || count > row.size() - x || bytes.ended()) return false;
    const std::uint8_t value = run ? bytes.next() : 0;
    for (std::size_t k = 0; k < count; ++k) row[x++][component] = run ? value : bytes.next();
  }
  return !bytes.ended();
}

// A row as plain pixels, in which (1, 1, 1, n) repeats the pixel before it; n's in sequence are digits to base 256.
bool read_plain_row(Bytes& bytes, std::vector<Rgbe>& row, Rgbe first) {
  int shift = 0;
  Rgbe pixel = first;
  for (std::size_t x = 0; x < row.size(); pixel = x < row.size() ? bytes.next_pixel() : pixel) {
    if (bytes.ended()) return false;
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel;
      shift = 0;
      continue;
    }
    if (x == 0 || shift > 16) return false;
    const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
    if (count > row.size() - x) return false;
    for (std::size_t k = 0; k < count; ++k, ++x) row[x] = row[x - 1];
    shift += 8;
  }
  return true;
}

bool read_row(Bytes& bytes, std::vector<Rgbe>& row) {
  const Rgbe first = bytes.next_pixel();
  if (bytes.ended()) return false;
  const int width = static_cast<int>(row.size());
  const bool coded =
      width >= shortest_coded_row && width <= longest_coded_row && first[0] == 2 && first[1] == 2 && first[2] < 128;
  if (!coded) return read_plain_row(bytes, row, first);
  if ((first[2] << 8 | first[3]) != width) return false;
  for (std::size_t component = 0; component < 4; ++component)
    if (!read_component(bytes, row, component)) return false;
  return true;
}

void add_pixel(PixelSink& sink, const Rgbe& pixel, const std::array<double, 3>& divisor) {
  const double scale = pixel[3] == 0 ? 0 : std::ldexp(1.0, pixel[3] - exponent_bias);
  std::array<float, 3> rgb;
  for (std::size_t i = 0; i < 3; ++i) rgb[i] = static_cast<float>(pixel[i] * scale / divisor[i]);
  sink.add(rgb);
}

}  // namespace

Result<RgbImage> decode_hdr(std::string_view data, const std::string& source) try {
  Bytes bytes(data);
  const Result<Header> header = read_header(bytes, source);
  if (!header) return header.errors();
  PixelSink sink(source, header->width, header->height, {});
  std::vector<Rgbe> row(static_cast<std::size_t>(header->width));
  for (int y = 0; y < header->height && sink.ok(); ++y) {
    if (!read_row(bytes, row))
      return picture_error(source, std::string(bytes.ended() ? "truncated" : "damaged") + " in row " +
                                       std::to_string(y) + " of " + std::to_string(header->height));
    for (const Rgbe& pixel : row) add_pixel(sink, pixel, header->divisor);
  }
  return sink.take();
} catch (const std::bad_alloc&) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
}

Result<RgbImage> read_hdr(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  return decode_hdr(*bytes, path.string());
}

}  // namespace shabon::io
