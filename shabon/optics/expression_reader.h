// Reads a stack expression character by character and keeps the problems found, each at its place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::optics {

class ExpressionReader {
 public:
  explicit ExpressionReader(std::string_view text) : text_(text) {}

  std::size_t offset() const { return offset_; }  // in bytes
  void go_to(std::size_t offset) { offset_ = offset; }
  bool at_end() const { return offset_ >= text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[offset_]; }
  bool at(char c) const { return !at_end() && text_[offset_] == c; }
  bool at_number() const;     // a digit, a sign or a point
  bool at_letter() const;     // or any character beyond ASCII
  bool at_delimiter() const;  // the end, white space or one of | ( ) ^, and a comma in a list

  bool in_list() const { return in_list_; }  // between the brackets of a mixture
  void set_in_list(bool in_list) { in_list_ = in_list; }

  void advance() { ++offset_; }
  void skip_space();
  void skip_element();  // to the next | or ) or the end

  std::string_view from(std::size_t begin) const { return text_.substr(begin, offset_ - begin); }

  // The text of a decimal number with optional sign, point and exponent; empty when there is none. The points of a
  // range, 1..2, belong to no number.
  std::string_view take_number();
  std::string_view take_letters();
  std::string_view take_until_delimiter();
  // The characters up to the next `end`, which is skipped too; without one, everything up to the end of the text.
  std::string_view take_through(char end, bool& found);

  // "expected <what>, got <whatever stands at the offset>".
  void expected(const std::string& what, std::size_t offset, std::string_view hint = {});
  void problem(std::size_t offset, std::string message);  // nothing when the last one stands at the same place
  // Problems that lie elsewhere keep their place; those without one get this offset.
  void problems(std::size_t offset, const Diagnostics& found);

  bool has_problems() const { return !problems_.empty(); }
  bool has_problems_since(std::size_t offset) const;  // at or after it
  bool stopped() const { return stopped_; }           // too many problems, or one that leaves nothing to read
  void stop() { stopped_ = true; }

  // In the order of the text.
  Diagnostics take_problems();

 private:
  void add(std::size_t offset, Diagnostic diagnostic);

  std::string_view text_;
  std::size_t offset_ = 0;
  std::vector<std::pair<std::size_t, Diagnostic>> problems_;
  bool stopped_ = false;
  bool in_list_ = false;
};

}  // namespace shabon::optics
