#include "shabon/io/csv.h"

#include <algorithm>
#include <new>
#include <utility>

#include "shabon/base/text.h"
#include "shabon/io/file.h"
#include "shabon/io/text_lines.h"

namespace shabon::io {

namespace {

constexpr std::size_t most_errors = 20;  // of one column

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Reads rows from a text with plain line ends. A quoted cell may hold line ends.
class CsvParser {
 public:
  CsvParser(std::string_view text, CsvTable& table) : text_(text), table_(table) {}

  bool parse() {  // false with the error recorded
    while (at_ < text_.size()) {
      const std::string_view line = text_.substr(at_, text_.find('\n', at_) - at_);
      if (trim(line).empty() || line.front() == '#') {
        if (!trim(line).empty()) table_.comments.emplace_back(line.substr(1));
        at_ = std::min(at_ + line.size() + 1, text_.size());
        ++line_;
      } else if (!parse_row()) {
        return false;
      }
      line_start_ = at_;
    }
    return true;
  }

  Diagnostics take_errors() { return std::move(errors_); }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\n'; }
  bool at_line_end() const { return here() == '\n'; }

  int column() const { return static_cast<int>(count_characters(text_.substr(line_start_), at_ - line_start_)) + 1; }

  bool refuse(int line, int at_column, std::string message) {
    errors_ = {diagnostic_at(table_.source, table_.lines, line, at_column, std::move(message))};
    return false;
  }

  bool parse_row() {
    CsvRow row;
    row.line = line_;
    while (true) {
      CsvCell cell;
      if (!parse_cell(cell)) return false;
      row.cells.push_back(std::move(cell));
      const bool more = here() == ',';
      if (!more && !at_line_end()) return refuse(line_, column(), "expected ',' or the line's end after a quoted cell");
      if (at_ < text_.size()) ++at_;
      if (!more) break;
    }
    ++line_;
    if (!table_.rows.empty() && row.cells.size() != table_.rows.front().cells.size())
      return refuse(row.line, row.cells.back().column,
                    "expected " + std::to_string(table_.rows.front().cells.size()) + " cells, got " +
                        std::to_string(row.cells.size()));
    table_.rows.push_back(std::move(row));
    return true;
  }

  bool parse_cell(CsvCell& cell) {
    while (is_blank(here())) ++at_;
    cell.column = column();
    if (here() == '"') return parse_quoted(cell);
    const std::size_t begin = at_;
    while (here() != ',' && !at_line_end()) ++at_;
    cell.text = std::string(trim(text_.substr(begin, at_ - begin)));
    return true;
  }

  bool parse_quoted(CsvCell& cell) {
    const int line = line_;
    for (++at_; at_ < text_.size(); ++at_) {
      const bool quote = text_[at_] == '"';
      if (quote && (at_ + 1 == text_.size() || text_[at_ + 1] != '"')) {
        ++at_;
        while (is_blank(here())) ++at_;
        return true;
      }
      if (quote) ++at_;  // a doubled quote stands for one
      cell.text += text_[at_];
      if (text_[at_] == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      }
    }
    return refuse(line, cell.column, "a quoted cell without its closing quote");
  }

  std::string_view text_;
  CsvTable& table_;
  Diagnostics errors_;
  std::size_t at_ = 0, line_start_ = 0;
  int line_ = 1;
};

bool holds_numbers_only(const CsvRow& row) {
  return std::all_of(row.cells.begin(), row.cells.end(),
                     [](const CsvCell& cell) { return parse_number(cell.text).has_value(); });
}

// Turns the first row into names, unless it holds numbers.
Diagnostics take_header(CsvTable& table) {
  const auto without_rows = [&] {
    return Diagnostics{diagnostic_at(table.source, table.lines, 1, 1, "a table without rows")};
  };
  if (table.rows.empty()) return without_rows();
  if (holds_numbers_only(table.rows.front())) return {};
  const CsvRow header = std::move(table.rows.front());
  table.rows.erase(table.rows.begin());
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string& name = header.cells[i].text;
    if (table.column(name))
      return {diagnostic_at(table, header, i, "a second column named '" + printable(name, 60) + "'")};
    table.columns.push_back(name);
  }
  if (table.rows.empty()) return without_rows();
  return {};
}

}  // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (same_name(columns[i], name)) return i;
  return {};
}

Result<CsvTable> parse_csv(std::string_view text, std::string source) try {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (const auto defect = find_text_defect(text)) return Diagnostics{to_diagnostic(source, text, *defect)};
  const std::string plain = with_plain_line_ends(text);
  CsvTable table;
  table.source = std::move(source);
  table.lines = split_lines(plain);
  CsvParser parser(plain, table);
  if (!parser.parse()) return parser.take_errors();
  if (Diagnostics errors = take_header(table); !errors.empty()) return errors;
  return table;
} catch (const std::bad_alloc&) {
  return fail(Failure::content, "not enough memory for this table");
}

Result<CsvTable> read_csv(const std::filesystem::path& path) {
  const Result<std::string> text = read_text_file(path, csv_max_bytes);
  if (!text) return text.errors();
  return parse_csv(*text, path.string());
}

Diagnostic diagnostic_at(const CsvTable& table, const CsvRow& row, std::size_t cell, std::string message) {
  const int column = cell < row.cells.size() ? row.cells[cell].column : 1;
  return diagnostic_at(table.source, table.lines, row.line, column, std::move(message));
}

Result<std::vector<double>> numbers(const CsvTable& table, std::string_view column) {
  if (const auto index = table.column(column)) return numbers(table, *index);
  std::string found;
  for (const std::string& name : table.columns) found += (found.empty() ? "" : ", ") + printable(name, 40);
  Diagnostics errors = fail(Failure::content, "no column '" + printable(column, 60) + "'; found: " +
                                                  (found.empty() ? "columns without names" : printable(found, 200)));
  errors[0].source = table.source;
  return errors;
}

Result<std::vector<double>> numbers(const CsvTable& table, std::size_t column) {
  std::vector<double> values;
  values.reserve(table.rows.size());
  Diagnostics errors;
  for (const CsvRow& row : table.rows) {
    const std::string text = column < row.cells.size() ? row.cells[column].text : std::string();
    if (const auto value = parse_number(text)) {
      values.push_back(*value);
    } else {
      errors.push_back(diagnostic_at(table, row, column, "expected a number, got '" + printable(text, 60) + "'"));
      if (errors.size() == most_errors) break;
    }
  }
  if (!errors.empty()) return errors;
  return values;
}

std::string csv_cell(std::string_view text) {
  const bool plain = text.find_first_of(",\"\r\n#") == std::string_view::npos && text == trim(text);
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

CsvWriter::CsvWriter(std::span<const std::string> columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) text_ += (i ? "," : "") + csv_cell(columns[i]);
  text_ += '\n';
}

void CsvWriter::row(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) text_ += (i ? "," : "") + format_exact(values[i]);
  text_ += '\n';
}

}  // namespace shabon::io
