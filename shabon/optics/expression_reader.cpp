#include "shabon/optics/expression_reader.h"

#include <algorithm>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

constexpr std::size_t most_problems = 20;
constexpr std::size_t most_shown_characters = 40;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_delimiter(char c) { return is_space(c) || c == '|' || c == '(' || c == ')' || c == '^'; }
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

bool ExpressionReader::at_number() const { return is_digit(peek()) || at('.') || at('+') || at('-'); }
bool ExpressionReader::at_letter() const { return is_letter(peek()); }
bool ExpressionReader::at_delimiter() const { return at_end() || is_delimiter(peek()) || (in_list_ && at(',')); }

void ExpressionReader::skip_space() {
  while (is_space(peek())) advance();
}

void ExpressionReader::skip_element() {
  while (!at_end() && !at('|') && !at(')')) advance();
}

std::string_view ExpressionReader::take_number() {
  const std::size_t begin = offset_;
  const auto take_digits = [&] {
    const std::size_t first = offset_;
    while (is_digit(peek())) advance();
    return offset_ > first;
  };
  if (at('+') || at('-')) advance();
  bool digits = take_digits();
  const bool is_range = text_.substr(offset_).starts_with("..");
  if (at('.') && !is_range) {
    advance();
    digits = take_digits() || digits;
  }
  if (!digits) {
    offset_ = begin;
    return {};
  }
  const std::size_t mantissa_end = offset_;
  if (at('e') || at('E')) {
    advance();
    if (at('+') || at('-')) advance();
    if (!take_digits()) offset_ = mantissa_end;
  }
  return from(begin);
}

std::string_view ExpressionReader::take_letters() {
  const std::size_t begin = offset_;
  while (at_letter()) advance();
  return from(begin);
}

std::string_view ExpressionReader::take_until_delimiter() {
  const std::size_t begin = offset_;
  while (!at_delimiter()) advance();
  return from(begin);
}

std::string_view ExpressionReader::take_through(char end, bool& found) {
  const std::size_t begin = offset_;
  const std::size_t place = text_.find(end, begin);
  found = place != std::string_view::npos;
  offset_ = found ? place + 1 : text_.size();
  return text_.substr(begin, place - begin);
}

void ExpressionReader::expected(const std::string& what, std::size_t offset, std::string_view hint) {
  std::string got = "the end";
  if (offset < text_.size()) {
    std::size_t end = offset;
    while (end < text_.size() && !is_delimiter(text_[end]) && !(in_list_ && text_[end] == ',')) ++end;
    got = "'" + printable(text_.substr(offset, std::max<std::size_t>(end - offset, 1)), most_shown_characters) + "'";
  }
  problem(offset, "expected " + what + ", got " + got + std::string(hint));
}

void ExpressionReader::problem(std::size_t offset, std::string message) {
  if (!problems_.empty() && problems_.back().first == offset) return;  // one place, one message
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  add(offset, std::move(diagnostic));
}

void ExpressionReader::problems(std::size_t offset, const Diagnostics& found) {
  for (const Diagnostic& diagnostic : found) add(offset, diagnostic);
}

void ExpressionReader::add(std::size_t offset, Diagnostic diagnostic) {
  if (problems_.size() >= most_problems) {
    stopped_ = true;
    return;
  }
  problems_.emplace_back(offset, std::move(diagnostic));
}

bool ExpressionReader::has_problems_since(std::size_t offset) const {
  return std::any_of(problems_.begin(), problems_.end(), [&](const auto& problem) { return problem.first >= offset; });
}

Diagnostics ExpressionReader::take_problems() {
  std::stable_sort(problems_.begin(), problems_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Diagnostics result;
  for (auto& [offset, diagnostic] : problems_) {
    if (diagnostic.source.empty()) {
      diagnostic.source = "<stack>";
      diagnostic.line = 1;
      diagnostic.column = static_cast<int>(utf8_characters(text_.substr(0, offset)).size()) + 1;
      diagnostic.excerpt = std::string(text_);
    }
    result.push_back(std::move(diagnostic));
  }
  return result;
}

}  // namespace shabon::optics
