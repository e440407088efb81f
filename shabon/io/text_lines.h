// Places in a text: its lines, its columns in characters, and what makes it no text at all.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/diagnostic.h"

namespace shabon::io {

// More lines than this are refused: a vector of empty lines would take many times the space of the file.
inline constexpr std::size_t text_max_lines = 1'000'000;

// The text with every line end ("\r\n", "\r") written as '\n'.
std::string with_plain_line_ends(std::string_view text);

// The lines of a text with plain line ends; at least one. A final '\n' begins no further line.
std::vector<std::string> split_lines(std::string_view text);

// How many characters the first `bytes` bytes of a UTF-8 text hold.
std::size_t count_characters(std::string_view text, std::size_t bytes);

// An error of Failure::content at a place; line and column count from 1. The excerpt is left out where the line is
// unknown or too long to be worth keeping.
Diagnostic diagnostic_at(const std::string& source, const std::vector<std::string>& lines, int line, int column,
                         std::string message, std::string key = {});

// The first thing that makes `text` unfit to be read as text: a NUL or another control character (tab and line ends are
// fine), a byte sequence that is not UTF-8, or more than text_max_lines lines.
struct TextDefect {
  std::size_t offset = 0;  // in bytes
  std::string message;
};
std::optional<TextDefect> find_text_defect(std::string_view text);

// The diagnostic for a defect of `text`, which need not be splittable into lines.
Diagnostic to_diagnostic(const std::string& source, std::string_view text, const TextDefect& defect);

}  // namespace shabon::io
