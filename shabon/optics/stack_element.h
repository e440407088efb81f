// One element of a stack expression: what stands between two bars.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/optics/expression_reader.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::optics {

inline constexpr std::string_view medium_forms = "a medium (a number, a name, file:PATH or mix(...))";
inline constexpr std::string_view thickness_form = "a thickness such as 300nm";

// nm, um, mm, ...
bool is_length_unit(std::string_view name);

// A medium with whatever follows it. Offsets count bytes of the text.
struct StackElement {
  std::size_t begin = 0;
  std::optional<Medium> medium;  // nothing when it could not be read
  std::size_t medium_end = 0;
  std::optional<std::size_t> thickness_begin;  // nothing when there is no thickness
  double thickness_nm = 0;
  std::optional<UnknownThickness> unknown;  // with a thickness_nm of 0
  bool coherent = true;
  bool broken = false;  // its problems are kept by the reader
};

class StackElementParser {
 public:
  struct Unit {
    std::string_view name;
    double nm;
  };

  // Both outlive the parser.
  StackElementParser(ExpressionReader& reader, const MediumResolver& resolver, bool unknowns_allowed = false)
      : reader_(reader), resolver_(resolver), unknowns_allowed_(unknowns_allowed) {}

  // From the reader's offset; leaves it before the |, ( or ) that follows, or at the end.
  StackElement parse();

  // What stands before a thickness. Nothing after a problem, which the reader keeps.
  std::optional<Medium> parse_medium();

 private:
  std::optional<Medium> parse_index();
  std::optional<double> parse_real(std::size_t begin);
  bool parse_imaginary(double& k);
  std::optional<Medium> check_index(std::size_t begin, double n, double k);
  std::optional<Medium> parse_name();
  std::optional<Medium> parse_file();
  std::optional<Medium> parse_mixture(std::size_t begin);
  bool parse_part(std::vector<MixturePart>& parts, std::optional<std::size_t>& without_share);
  bool parse_share(double& fraction);
  std::optional<Medium> mixed(std::size_t begin, std::vector<MixturePart> parts,
                              std::optional<std::size_t> without_share);
  std::optional<Medium> resolve(std::string_view name, bool is_file, std::size_t offset);
  bool at_thickness() const;
  bool parse_thickness(StackElement& element);
  const Unit* parse_unit(std::string_view digits);
  bool parse_range(StackElement& element, double low, std::size_t begin);
  bool check_thickness(double thickness_nm, std::size_t begin);

  ExpressionReader& reader_;
  const MediumResolver& resolver_;
  const bool unknowns_allowed_;
  std::map<std::pair<bool, std::string>, std::optional<Medium>> resolved_;  // each name once
};

}  // namespace shabon::optics
