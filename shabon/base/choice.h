// An entry of a field list: a std::variant member whose alternatives' keys stand in the same mapping, exactly one of
// them.
#pragma once

namespace shabon {

template <class Struct, class Variant>
struct Choice {
  Variant Struct::*member;
};
template <class Struct, class Variant>
Choice(Variant Struct::*) -> Choice<Struct, Variant>;

}  // namespace shabon
