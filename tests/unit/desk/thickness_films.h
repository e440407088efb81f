// Films with an unknown thickness that the tests of the inverse problem share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "shabon/base/random.h"
#include "shabon/desk/thickness_model.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {

// `?` is 0..`high_nm`.
inline UnknownFilm unknown_film(std::string_view expression, double high_nm = 2000) {
  const auto parsed = optics::parse_stack_with_unknowns(expression);
  EXPECT_TRUE(parsed.ok()) << expression;
  UnknownFilm film{parsed->stack, {}};
  for (const optics::UnknownThickness& unknown : parsed->unknowns) {
    const optics::ThicknessRange range = unknown.range.value_or(optics::ThicknessRange{0, high_nm});
    film.unknowns.push_back({unknown.layers, range.low_nm, range.high_nm});
  }
  return film;
}

inline optics::Stack known_stack(const UnknownFilm& film, std::span<const double> thickness_nm) {
  optics::Stack stack = film.stack;
  for (std::size_t j = 0; j < film.unknowns.size(); ++j)
    for (const std::size_t layer : film.unknowns[j].layers) stack.layers[layer].thickness_nm = thickness_nm[j];
  return stack;
}

// Normally distributed with the variance 1 (Box and Muller).
inline double normal(Pcg32& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

}  // namespace shabon::desk
