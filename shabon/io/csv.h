// Tables as comma separated values (RFC 4180) with `#` comment lines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::io {

struct CsvCell {
  std::string text;  // blanks around it removed unless quoted
  int column = 0;    // where it begins in its line, counted from 1 in characters
};

struct CsvRow {
  int line = 0;  // counted from 1
  std::vector<CsvCell> cells;
};

struct CsvTable {
  std::string source;
  std::vector<std::string> lines;     // for excerpts
  std::vector<std::string> comments;  // lines that begin with '#', without it
  std::vector<std::string> columns;   // names from the first row; empty when that row holds numbers only
  std::vector<CsvRow> rows;           // all with the same number of cells

  std::optional<std::size_t> column(std::string_view name) const;  // ignores case
};

inline constexpr std::size_t csv_max_bytes = 16 << 20;

// Errors with line and column: a row with too few or too many cells, a quote that does not end, text after a closing
// quote, control characters, two columns of one name, a table without rows.
Result<CsvTable> parse_csv(std::string_view text, std::string source);
Result<CsvTable> read_csv(const std::filesystem::path& path);

// One column as finite numbers. Errors: no such column (the message names those found), a cell that is no finite number
// (with its place).
Result<std::vector<double>> numbers(const CsvTable& table, std::string_view column);
Result<std::vector<double>> numbers(const CsvTable& table, std::size_t column);

// An error of Failure::content that points at one cell.
Diagnostic diagnostic_at(const CsvTable& table, const CsvRow& row, std::size_t cell, std::string message);

// A cell, in quotes where its text needs them.
std::string csv_cell(std::string_view text);

// Builds a table's text: header, then rows of numbers with 17 significant digits. Lines end in '\n'.
class CsvWriter {
 public:
  explicit CsvWriter(std::span<const std::string> columns);
  void row(std::span<const double> values);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace shabon::io
