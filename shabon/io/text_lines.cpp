#include "shabon/io/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace shabon::io {

namespace {

constexpr std::size_t longest_excerpt_bytes = 64 << 10;

std::uint8_t byte_at(std::string_view text, std::size_t i) { return static_cast<std::uint8_t>(text[i]); }

// The length of the UTF-8 character at `i`, or 0 where there is none: the well-formed sequences of Unicode, table 3-7.
std::size_t character_length(std::string_view text, std::size_t i) {
  const std::uint8_t first = byte_at(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length == 0 || i + length > text.size()) return 0;
  const std::uint8_t lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;   // no overlong forms
  const std::uint8_t highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;  // no surrogates, nothing > 10FFFF
  if (byte_at(text, i + 1) < lowest || byte_at(text, i + 1) > highest) return 0;
  for (std::size_t k = 2; k < length; ++k)
    if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
  return length;
}

std::string hexadecimal(std::uint8_t byte) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

std::string with_plain_line_ends(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      plain += text[i];
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      plain += '\n';
    }
  }
  return plain;
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  lines.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
  while (true) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
    if (text.empty()) return lines;
  }
}

std::size_t count_characters(std::string_view text, std::size_t bytes) {
  const std::string_view part = text.substr(0, bytes);
  return static_cast<std::size_t>(
      std::count_if(part.begin(), part.end(), [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) != 0x80; }));
}

Diagnostic diagnostic_at(const std::string& source, const std::vector<std::string>& lines, int line, int column,
                         std::string message, std::string key) {
  Diagnostic diagnostic;
  diagnostic.source = source;
  diagnostic.line = line;
  diagnostic.column = column;
  diagnostic.message = std::move(message);
  diagnostic.key = std::move(key);
  if (line > 0 && static_cast<std::size_t>(line) <= lines.size()) {
    const std::string& text = lines[static_cast<std::size_t>(line) - 1];
    if (text.size() <= longest_excerpt_bytes) diagnostic.excerpt = text;
  }
  return diagnostic;
}

std::optional<TextDefect> find_text_defect(std::string_view text) {
  std::size_t lines = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::uint8_t byte = byte_at(text, i);
    if (byte == '\n' && ++lines > text_max_lines + 1)
      return TextDefect{i, "more than " + std::to_string(text_max_lines) + " lines"};
    if (byte == 0) return TextDefect{i, "a NUL byte; this is not a text file"};
    if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F)
      return TextDefect{i, "control character " + hexadecimal(byte)};
    const std::size_t length = character_length(text, i);
    if (length == 0) return TextDefect{i, "byte " + hexadecimal(byte) + " is not UTF-8 text"};
    i += length;
  }
  return {};
}

Diagnostic to_diagnostic(const std::string& source, std::string_view text, const TextDefect& defect) {
  const std::string before = with_plain_line_ends(text.substr(0, defect.offset));
  const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
  const std::string_view line_start = std::string_view(before).substr(begin);
  Diagnostic diagnostic;
  diagnostic.source = source;
  diagnostic.line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
  diagnostic.column = static_cast<int>(count_characters(line_start, line_start.size())) + 1;
  diagnostic.message = defect.message;
  if (line_start.size() <= longest_excerpt_bytes) {
    const std::string_view rest = text.substr(defect.offset, longest_excerpt_bytes);
    diagnostic.excerpt = std::string(line_start) + std::string(rest.substr(0, rest.find_first_of("\r\n")));
  }
  return diagnostic;
}

}  // namespace shabon::io
