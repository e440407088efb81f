// The index of a stack expression: 1.38, 2.4+0.01i, 3i.
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>

#include "shabon/base/text.h"
#include "shabon/optics/stack_element.h"

namespace shabon::optics {

namespace {

constexpr std::string_view index_form = "an index of magnitude 0.0001..10000";

}  // namespace

// The number at the offset; `begin` is where the message points.
std::optional<double> StackElementParser::parse_real(std::size_t begin) {
  const std::string_view digits = reader_.take_number();
  if (digits.empty()) {
    reader_.expected(std::string(medium_forms), begin);
    return {};
  }
  const auto value = parse_number(digits);
  if (!value) reader_.expected("a finite number", begin);
  return value;
}

// n, n+ki or ki.
std::optional<Medium> StackElementParser::parse_index() {
  const std::size_t begin = reader_.offset();
  const auto first = parse_real(begin);
  if (!first) return {};
  double n = *first, k = 0;
  if (reader_.at('i')) {
    reader_.advance();
    std::swap(n, k);
  } else if (!parse_imaginary(k)) {
    return {};
  }
  if (reader_.at_delimiter()) return check_index(begin, n, k);

  const std::size_t rest = reader_.offset();
  const bool is_thickness = is_length_unit(reader_.take_letters()) && reader_.at_delimiter();
  reader_.go_to(rest);
  if (is_thickness)
    reader_.expected(std::string(medium_forms) + " before the thickness", begin);
  else
    reader_.expected("a number such as 1.38 or 2.4+0.01i", begin);
  return {};
}

// "+ki" or "-ki" after n, when it is there. False after a problem.
bool StackElementParser::parse_imaginary(double& k) {
  const std::size_t real_end = reader_.offset();
  reader_.skip_space();
  const bool spaced = reader_.offset() > real_end;
  const std::size_t sign_begin = reader_.offset();
  if (!reader_.at('+') && !reader_.at('-')) {
    reader_.go_to(real_end);
    return true;
  }
  const double sign = reader_.at('-') ? -1 : 1;
  reader_.advance();
  reader_.skip_space();
  const std::string_view digits = reader_.at('+') || reader_.at('-') ? std::string_view() : reader_.take_number();
  if (!digits.empty() && reader_.at('i')) {
    reader_.advance();
    const auto value = parse_number(digits);
    if (!value) reader_.expected("a finite number", sign_begin);
    k = sign * value.value_or(0);
    if (k < 0) reader_.expected("k >= 0 in n+ki (k > 0 absorbs)", sign_begin);
    return value && !(k < 0);
  }
  if (spaced) {  // a thickness with a sign
    reader_.go_to(real_end);
    return true;
  }
  reader_.expected("an imaginary part such as +0.01i", sign_begin);
  return false;
}

std::optional<Medium> StackElementParser::check_index(std::size_t begin, double n, double k) {
  if (n < 0) {
    reader_.expected("an index n >= 0", begin);
    return {};
  }
  if (k < 0) {
    reader_.expected("k >= 0 in ki (k > 0 absorbs)", begin);
    return {};
  }
  const std::complex<double> index(n + 0.0, k + 0.0);  // no negative zeros
  const double magnitude = std::abs(index);
  if (!(magnitude >= smallest_index && magnitude <= largest_index)) {
    reader_.expected(std::string(index_form), begin);
    return {};
  }
  return Medium::constant(index);
}

}  // namespace shabon::optics
