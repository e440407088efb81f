// Thickness model: noise on any other model, (68), (69): plane waves of random directions in space, a few octaves of
// them. Every wave belongs to one octave, so that the noise ends where the last octave ends, and space has neither seam
// nor pole; a seed gives the same film at any size of the picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/base/indirect.h"
#include "shabon/film/number.h"
#include "shabon/film/range.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct BaseThickness;  // any model: thickness.h

struct NoiseThickness {
  Indirect<BaseThickness> base;
  double amplitude = 0.1;
  double scale = 0.8;
  int octaves = 4;
  double roughness = 0.5;
  double stretch = 1;
  double swirl = 0;
  std::uint64_t seed = 1;
};

constexpr About about(Of<NoiseThickness>) { return {.name = "noise", .doc = "Another model with noise on it, (68)."}; }

constexpr auto fields(Of<NoiseThickness>) {
  using Model = NoiseThickness;
  return std::tuple{
      Field{"base", &Model::base, {.required = true, .doc = "the thickness that the noise lies on"}},
      Field{"amplitude",
            &Model::amplitude,
            {.range = {.low = 0, .high = 1}, .doc = "standard deviation, as a share of the thickness"}},
      Field{"scale",
            &Model::scale,
            {.range = {.low = 0.01, .high = 10}, .doc = "length of the longest waves, in radii of the bubble"}},
      Field{"octaves",
            &Model::octaves,
            {.range = {.low = 1, .high = 8}, .doc = "layers of noise, each with waves half as long as the one before"}},
      Field{"roughness",
            &Model::roughness,
            {.range = {.low = 0, .high = 1}, .doc = "how strong a layer is against the one before"}},
      Field{"stretch",
            &Model::stretch,
            {.range = {.low = 0.05, .high = 20},
             .doc = "above 1: flattened into level bands by so much; below 1: upright"}},
      Field{
          "swirl",
          &Model::swirl,
          {.range = {.low = 0, .high = 4}, .doc = "how far slower noise drags it into swirls, in lengths of `scale`"}},
      Field{"seed", &Model::seed, {.range = {.low = 0}, .doc = "another number, another film"}}};
}

// Phases in cycles, places in radii.
struct Wave {
  double x, y, z;  // cycles per radius
  double phase;
  double amplitude;
};

struct NoiseWaves {
  std::vector<Wave> waves;
  std::array<std::vector<Wave>, 3> swirls;  // displacement of x, y and z in radii; empty: none
  double mean = 0;                          // of the waves over the sphere, in the absence of swirls: taken away
};

// The waves of a model, for a standard deviation of 1 in space.
NoiseWaves noise_waves(const NoiseThickness& model);

namespace detail {

// cos(2 pi x): the absolute error is below 4e-7.
template <class Number>
Number cosine_of_cycles(const Number& x) {
  // To the nearest whole number as packets do it: for |x| < 2^50.
  const Number whole = (x + Number(0x1.8p52)) - Number(0x1.8p52), f = x - whole, y = f * f;
  // sin(pi f)/f, least maximum relative error 1.8e-7 on |f| <= 1/2.
  Number p = y * Number(-7.3704309e-3) + Number(8.2145887e-2);
  for (const double c : {-5.9926453e-1, 2.5501640, -5.1677128, 3.1415927}) p = p * y + Number(c);
  return Number(1.0) - Number(2.0) * y * p * p;
}

template <class Number>
Number sum_of(const std::vector<Wave>& waves, const math::Vec3<Number>& at) {
  Number sum(0.0);
  for (const Wave& wave : waves)
    sum = sum + Number(wave.amplitude) * cosine_of_cycles<Number>(Number(wave.x) * at.x + Number(wave.y) * at.y +
                                                                  Number(wave.z) * at.z + Number(wave.phase));
  return sum;
}

}  // namespace detail

// The noise itself at a place, in radii from the centre: mean 0, standard deviation 1.
template <class Number>
Number noise_at(const NoiseWaves& noise, const math::Vec3<Number>& at) {
  if (noise.swirls[0].empty()) return detail::sum_of(noise.waves, at) - Number(noise.mean);
  const math::Vec3<Number> dragged{at.x + detail::sum_of(noise.swirls[0], at),
                                   at.y + detail::sum_of(noise.swirls[1], at),
                                   at.z + detail::sum_of(noise.swirls[2], at)};
  return detail::sum_of(noise.waves, dragged);
}

struct HeldField;  // a ThicknessField: thickness_field.h

struct NoiseField {
  Indirect<HeldField> base;
  double amplitude = 0;
  std::shared_ptr<const NoiseWaves> waves;
};

NoiseField prepared(const NoiseThickness& model, double seconds);

}  // namespace shabon::film
