#include "bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "shabon/io/file.h"

namespace shabon::bench {

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const double median = n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  return {median, values.front(), values.back(), static_cast<int>(n)};
}

std::string shown(const Spread& s, int digits) {
  return fmt::format("{:.{}f} ({:.{}f}..{:.{}f})", s.median, digits, s.least, digits, s.most, digits);
}

std::string verdict(bool reached, std::string_view goal) {
  return fmt::format("{}: {}", goal, reached ? "reached" : "missed");
}

std::string Table::markdown() const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    text += '|';
    for (std::size_t i = 0; i < rows_[r].size(); ++i)
      text +=
          i == 0 ? fmt::format(" {:<{}} |", rows_[r][i], widths[i]) : fmt::format(" {:>{}} |", rows_[r][i], widths[i]);
    text += '\n';
    if (r > 0) continue;
    text += '|';
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += i == 0 ? fmt::format("{:-<{}}|", "", widths[i] + 2) : fmt::format("{:-<{}}:|", "", widths[i] + 1);
    text += '\n';
  }
  return text;
}

void Report::print(const std::string& text) {
  text_ += text;
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void Report::heading(std::string_view text) { print(fmt::format("### {}\n\n", text)); }
void Report::paragraph(std::string_view text) { print(fmt::format("{}\n\n", text)); }
void Report::table(const Table& table) { print(table.markdown() + "\n"); }

void Report::record(std::string_view section, std::string_view name, std::string_view unit, const Spread& value) {
  figures_.push_back(fmt::format(
      R"(  {{"section": "{}", "name": "{}", "unit": "{}", "median": {}, "min": {}, "max": {}, "repetitions": {}}})",
      section, name, unit, value.median, value.least, value.most, value.count));
}

std::string Report::json() const { return fmt::format("[\n{}\n]\n", fmt::join(figures_, ",\n")); }

Status update_page(const std::string& path, std::string_view text) {
  constexpr std::string_view begin = "<!-- bench: begin -->\n", end = "<!-- bench: end -->";
  constexpr std::size_t most_bytes = 1 << 20;
  const auto page = io::read_text_file(path, most_bytes);
  if (!page) return page.errors();
  const std::size_t from = page->find(begin), to = page->find(end);
  if (from == std::string::npos || to == std::string::npos || to < from)
    return fail(Failure::content, path + ": expected the lines <!-- bench: begin --> and <!-- bench: end -->");
  std::string updated = page->substr(0, from + begin.size());
  updated.append(text).append(page->substr(to));
  return io::write_file_atomically(path, updated);
}

}  // namespace shabon::bench
