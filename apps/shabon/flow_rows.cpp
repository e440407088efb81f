#include "flow_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{1} << 30;

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"frame"};
  std::apply([&](const auto&... field) { (names.emplace_back(field.key), ...); }, film::fields(Of<film::FlowReport>{}));
  return names;
}

std::vector<double> row_of(int frame, const film::FlowReport& report) {
  std::vector<double> row = {static_cast<double>(frame)};
  std::apply([&](const auto&... field) { (row.push_back(static_cast<double>(report.*field.member)), ...); },
             film::fields(Of<film::FlowReport>{}));
  return row;
}

// The numbers of a line; nothing when it is no row that may follow the frame `last`.
std::optional<std::vector<double>> row_in(std::string_view line, std::size_t count, double last) {
  std::vector<double> row;
  for (const std::string_view cell : split(line, ',')) {
    const auto number = parse_number(trim(cell));
    if (!number) return {};
    row.push_back(*number);
  }
  if (row.size() != count || row.front() != std::floor(row.front()) || !(row.front() > last)) return {};
  return row;
}

Diagnostic at_line(const fs::path& path, int line, std::string message) {
  Diagnostic found;
  found.source = path.string();
  found.line = line;
  found.message = std::move(message);
  return found;
}

}  // namespace

Result<FlowRows> FlowRows::read(const fs::path& path, Diagnostics& warnings) {
  FlowRows rows;
  std::error_code error;
  if (!fs::exists(path, error)) return rows;
  const auto text = io::read_text_file(path, most_bytes);
  if (!text) return text.errors();
  const std::vector<std::string> names = column_names();
  const std::string header = fmt::format("{}", fmt::join(names, ","));
  std::vector<std::string_view> lines = split(*text, '\n');
  const std::string_view unfinished = lines.back();  // empty when the last line ends
  lines.pop_back();
  if (lines.empty() && header.starts_with(trim(unfinished))) return rows;
  const std::string_view first = trim(lines.empty() ? unfinished : lines.front());
  if (first != header)
    return Diagnostics{at_line(path, 1,
                               fmt::format("expected the columns '{}', got '{}'; move the file away to go on without "
                                           "its rows",
                                           header, printable(first, 200)))};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double last = rows.rows_.empty() ? -1 : rows.rows_.back().front();
    if (auto row = row_in(lines[i], names.size(), last)) {
      rows.rows_.push_back(std::move(*row));
      continue;
    }
    if (i + 1 == lines.size()) break;  // cut off, and ended by something else
    warnings.push_back(
        at_line(path, static_cast<int>(i + 1),
                fmt::format("expected {} numbers, of a later frame than {}, got '{}'; the line is left "
                            "out",
                            names.size(), last < 0 ? "any before" : format_number(last), printable(lines[i], 60))));
    warnings.back().severity = Severity::warning;
  }
  return rows;
}

void FlowRows::forget_after(int frame) {
  std::erase_if(rows_, [&](const std::vector<double>& row) { return row.front() > frame; });
}

void FlowRows::put(int frame, const film::FlowReport& report) {
  forget_after(frame);
  if (!rows_.empty() && rows_.back().front() == frame) rows_.pop_back();
  rows_.push_back(row_of(frame, report));
}

std::optional<std::string> FlowRows::missing_until(int last) const {
  std::string text;
  const auto add = [&](int from, int to) {
    if (from > to) return;
    text += (text.empty() ? "" : ", ") + (from == to ? fmt::format("{}", from) : fmt::format("{} to {}", from, to));
  };
  int next = 0;
  for (const std::vector<double>& row : rows_) {
    if (row.front() > last) break;
    add(next, static_cast<int>(row.front()) - 1);
    next = static_cast<int>(row.front()) + 1;
  }
  add(next, last);
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string FlowRows::text() const {
  const std::vector<std::string> names = column_names();
  io::CsvWriter table(names);
  for (const std::vector<double>& row : rows_) table.row(row);
  return table.text();
}

}  // namespace shabon::app
