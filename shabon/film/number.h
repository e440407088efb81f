// What packets have and a plain double lacks, so that one template serves both.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace shabon::film {

template <class Number>
inline constexpr bool is_one_number = std::is_same_v<Number, double>;

inline double select(bool yes, double a, double b) { return yes ? a : b; }

template <class Number>
constexpr int lane_count_of() {
  if constexpr (is_one_number<Number>)
    return 1;
  else
    return Number::size;
}

template <class Number>
void to_lanes(const Number& number, double* lanes) {
  if constexpr (is_one_number<Number>)
    *lanes = number;
  else
    number.store(lanes);
}

template <class Number>
Number from_lanes(const double* lanes) {
  if constexpr (is_one_number<Number>)
    return *lanes;
  else
    return Number::load(lanes);
}

// The angle of (x, y) in radians, -pi..pi; of packets the absolute error is below 4e-7.
template <class Number>
Number angle_of(const Number& y, const Number& x) {
  if constexpr (is_one_number<Number>) {
    return std::atan2(y, x);
  } else {
    const Number ax = abs(x), ay = abs(y);
    const Number t = min(ax, ay) / max(max(ax, ay), Number(1e-300));
    const Number s = t * t;
    // atan(t)/t on 0..1, least maximum error, degree 8 in t^2.
    Number p = s * Number(0.0028662257) - Number(0.0161657367);
    for (const double c : {0.0429096138, -0.0752896400, 0.1065626393, -0.1420889944, 0.1999355085, -0.3333314528})
      p = p * s + Number(c);
    Number angle = p * s * t + t;
    angle = select(ay > ax, Number(std::numbers::pi / 2) - angle, angle);
    angle = select(x < Number(0.0), Number(std::numbers::pi) - angle, angle);
    return select(y < Number(0.0), -angle, angle);
  }
}

}  // namespace shabon::film
