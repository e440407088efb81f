#include "shabon/api/nk_csv_dialect.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/io/text_lines.h"

namespace shabon::api {

namespace {

bool is_content(std::string_view line) { return !trim(line).empty() && line.front() != '#'; }

bool is_numeric(std::string_view cell) {
  return cell.find_first_of("0123456789") != std::string_view::npos &&
         cell.find_first_not_of("0123456789.,+-eE \t") == std::string_view::npos;
}

// What separates the columns besides ','; nothing where that does.
std::optional<char> separator_of(const std::vector<std::string>& lines) {
  const auto first = std::find_if(lines.begin(), lines.end(), is_content);
  if (first == lines.end() || first->find('"') != std::string::npos) return {};
  if (first->find(';') != std::string::npos) return ';';
  const std::vector<std::string_view> cells = split(*first, '\t');
  const auto beside_comma = [](std::string_view cell) {
    cell = trim(cell);
    return !cell.empty() && (cell.front() == ',' || cell.back() == ',');
  };
  if (cells.size() > 1 && std::none_of(cells.begin(), cells.end(), beside_comma)) return '\t';
  return {};
}

class Rewriter {
 public:
  Rewriter(char separator, const std::string& source, const std::vector<std::string>& lines)
      : separator_(separator), source_(source), lines_(lines) {}

  Result<std::string> rewrite() {
    std::string text;
    for (line_ = 0; line_ < lines_.size(); ++line_) {
      std::string line = lines_[line_];
      if (is_content(line)) {
        for (std::size_t begin = 0; begin <= line.size() && errors_.empty();) {
          const std::size_t end = std::min(line.find(separator_, begin), line.size());
          rewrite_cell(line, begin, end);
          if (end < line.size()) line[end] = ',';
          begin = end + 1;
          // Several tabs in a row only align the columns.
          while (separator_ == '\t' && begin < line.size() && line[begin] == '\t') line[begin++] = ' ';
        }
        if (!errors_.empty()) return errors_;
      }
      text += line + '\n';
    }
    return text;
  }

 private:
  void refuse(std::size_t begin, const std::string& message) {
    const int column = static_cast<int>(io::count_characters(lines_[line_], begin)) + 1;
    errors_ = {io::diagnostic_at(source_, lines_, static_cast<int>(line_) + 1, column, message)};
  }

  void rewrite_cell(std::string& line, std::size_t begin, std::size_t end) {
    const std::string cell = line.substr(begin, end - begin);
    const bool number = is_numeric(cell);
    std::replace(line.begin() + static_cast<std::ptrdiff_t>(begin), line.begin() + static_cast<std::ptrdiff_t>(end),
                 ',', number ? '.' : ' ');
    if (!number) return;
    const auto signs = std::count_if(cell.begin(), cell.end(), [](char c) { return c == '.' || c == ','; });
    if (signs == 0) return;
    const std::size_t place = begin + std::min(cell.find_first_not_of(" \t"), cell.size());
    const std::string shown = "got '" + printable(trim(cell), 60) + "'";
    if (signs > 1) return refuse(place, "expected a number with one decimal sign, " + shown);
    const char sign = cell.find(',') == std::string::npos ? '.' : ',';
    if (decimal_ && *decimal_ != sign)
      return refuse(place, std::string("expected '") + *decimal_ + "' as the decimal sign, as above, " + shown);
    decimal_ = sign;
  }

  char separator_;
  const std::string& source_;
  const std::vector<std::string>& lines_;
  std::size_t line_ = 0;
  std::optional<char> decimal_;
  Diagnostics errors_;
};

}  // namespace

Result<std::string> with_commas_and_points(std::string_view text, const std::string& source) {
  if (io::find_text_defect(text)) return std::string(text);  // told by the reader of tables
  const std::vector<std::string> lines = io::split_lines(io::with_plain_line_ends(text));
  const std::optional<char> separator = separator_of(lines);
  if (!separator) return std::string(text);
  return Rewriter(*separator, source, lines).rewrite();
}

}  // namespace shabon::api
