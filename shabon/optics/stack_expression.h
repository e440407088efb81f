// The stack expression: `air | water 300nm | air`, `1 | 1.38 99.6nm | 1.52`, `air | (ZnS 58nm | MgF2 99nm)^10 | glass`.
//
//   stack    = medium { "|" element } "|" medium          from the side the light comes from
//   element  = layer | "(" element { "|" element } ")" "^" count       groups nest, count 1..1000
//   layer    = medium thickness [ "incoherent" ]
//   medium   = index | name | "file:" path | "file:" '"' path '"' | mixture
//   mixture  = "mix" "(" part { "," part } ")"            part: medium [ number "%" ], of the volume
//   index    = n | n "+" k "i" | k "i"                    exponents allowed; k < 0 is an error
//   thickness = number unit                               unit: nm um µm mm cm, with or without a space
//
// An unquoted path ends at white space or "|", in a mixture also at ",". Names, `mix` and `incoherent` ignore case,
// units do not. The shares of `mix(water 70%, glycerol 30%)` make up 100 %; the last part may leave its share out and
// gets the rest. A mixture has at most 16 parts, no mixtures among them, and follows Lorentz and Lorenz (mixing.h).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/stack.h"

namespace shabon::optics {

// Finds the medium of a name, or of a file when `is_file`. Called once for each different name. Errors without a source
// are placed at the name in the expression; others (a line of an n-k file) are passed on as they are.
using MediumResolver = std::function<Result<Medium>(std::string_view name_or_file, bool is_file)>;

// Knows the names of media_library() and no files.
Result<Medium> resolve_from_library(std::string_view name_or_file, bool is_file);

// The whole text as one medium: `water`, `1.5+0.1i`, `file:a.csv`, `mix(water 70%, glycerol 30%)`. Errors as below,
// with source "<medium>".
Result<Medium> parse_medium(std::string_view text, const MediumResolver& resolver = resolve_from_library);

// The whole text as a stack. Errors: everything that is wrong, in order, up to a bound, each with source "<stack>",
// line 1, the column in characters and the text; a text longer than 1 MiB is refused unread.
Result<Stack> parse_stack(std::string_view text, const MediumResolver& resolver = resolve_from_library);

// A layer whose thickness is asked for: `water ?`, or within a range, `water 100..900nm`. In a repeated group it stands
// for all copies of that layer, which have one thickness.
struct ThicknessRange {
  double low_nm = 0, high_nm = 0;  // 0 <= low < high <= largest_thickness_nm
  friend bool operator==(const ThicknessRange&, const ThicknessRange&) = default;
};

struct UnknownThickness {
  std::size_t offset = 0;  // of the `?` or the range, in bytes of the text
  std::optional<ThicknessRange> range;
  std::vector<std::size_t> layers = {};  // indices into stack.layers, rising, at least one
};

struct StackWithUnknowns {
  Stack stack;                             // the unknown layers have the thickness 0
  std::vector<UnknownThickness> unknowns;  // in the order of the text
};

// parse_stack() for a text in which a thickness may also be `?` or a range:
//
//   thickness = number unit | "?" | number ".." number unit
Result<StackWithUnknowns> parse_stack_with_unknowns(std::string_view text,
                                                    const MediumResolver& resolver = resolve_from_library);

}  // namespace shabon::optics
