// Small unit types for the interfaces above the kernels: a number of nanometres cannot be passed as degrees.
#pragma once

#include <compare>
#include <numbers>

namespace shabon {

// A vacuum wavelength or a thickness.
struct Nanometres {
  double value = 0;
  constexpr Nanometres() = default;
  explicit constexpr Nanometres(double nm) : value(nm) {}
  constexpr auto operator<=>(const Nanometres&) const = default;
};

struct Radians {
  double value = 0;
  constexpr Radians() = default;
  explicit constexpr Radians(double rad) : value(rad) {}
  constexpr auto operator<=>(const Radians&) const = default;
};

struct Degrees {
  double value = 0;
  constexpr Degrees() = default;
  explicit constexpr Degrees(double deg) : value(deg) {}
  constexpr auto operator<=>(const Degrees&) const = default;
  constexpr operator Radians() const { return Radians(value * (std::numbers::pi / 180)); }
};

inline namespace unit_literals {
constexpr Nanometres operator""_nm(long double v) { return Nanometres(static_cast<double>(v)); }
constexpr Nanometres operator""_nm(unsigned long long v) { return Nanometres(static_cast<double>(v)); }
constexpr Degrees operator""_deg(long double v) { return Degrees(static_cast<double>(v)); }
constexpr Degrees operator""_deg(unsigned long long v) { return Degrees(static_cast<double>(v)); }
}  // namespace unit_literals

}  // namespace shabon
