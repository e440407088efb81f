// The members of a plain struct as one declarative list: key, member, unit, range, meaning. Reading, checking,
// suggestions and documentation follow from the list, so that a new member is written down once.
//
//   constexpr auto fields(Of<Lens>) {
//     return std::tuple{Field{"width_mm", &Lens::width_mm, {.unit = "mm", .range = positive, .doc = "..."}}};
//   }
//   constexpr About about(Of<Lens>) { return {.name = "lens", .doc = "..."}; }   // where Lens is one of several
//   choices
#pragma once

#include <limits>
#include <string_view>
#include <vector>

namespace shabon {

// Names the type an overload of fields() or about() speaks of.
template <class T>
struct Of {};

// An interval of finite numbers. An open end does not belong to it.
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool low_open = false;
  bool high_open = false;

  constexpr bool above_low(double x) const { return low_open ? x > low : x >= low; }
  constexpr bool below_high(double x) const { return high_open ? x < high : x <= high; }
  constexpr bool contains(double x) const { return above_low(x) && below_high(x); }
  constexpr bool has_low() const { return low > -std::numeric_limits<double>::max(); }
  constexpr bool has_high() const { return high < std::numeric_limits<double>::max(); }
};

using NameList = std::vector<std::string_view> (*)();

struct FieldInfo {
  std::string_view unit = {};  // "nm", "degrees", or empty
  Range range = {};            // of a number, or of every component of a vector
  bool required = false;       // otherwise the member's initial value is the default
  NameList names = nullptr;    // of a text: the closed set it is taken from, ignoring case
  std::string_view unset = {};  // of an optional member: what stands for it, for the table
  int items = 0;               // of a list: exactly so many; 0 leaves it open
  std::string_view doc = {};   // one line
};

template <class Struct, class Member>
struct Field {
  std::string_view key;
  Member Struct::*member;
  FieldInfo info;
};
template <class Struct, class Member>
Field(std::string_view, Member Struct::*, FieldInfo) -> Field<Struct, Member>;

// One of the types a std::variant can hold.
struct About {
  std::string_view name;
  std::string_view doc;
  bool flat = false;  // its keys stand beside those of its parent instead of below its name
};

}  // namespace shabon
