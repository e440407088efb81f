// Films to compare the packet kernels with the reference on: every number is one that float holds, so that both see
// the same film. Also the bookkeeping of the worst error.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "shabon/base/random.h"
#include "shabon/math/packet.h"
#include "shabon/optics/incidence.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

inline constexpr int lanes = 16;
using Float = math::packet<float, lanes>;
using Double = math::packet<double, lanes>;

// The packets' required accuracy against the reference.
inline constexpr double required = 2e-6;

// One ray meeting one film, for 16 wavelengths: the lossless film of index n2 >= n1 inside n1.
struct FilmCase {
  double n1[lanes], n2[lanes], wavelength_nm[lanes];
  double thickness_nm, cos_i;

  Incidence incidence() const { return incidence_from_cos(cos_i); }
  std::string lane_text(int i) const {
    char text[160];
    std::snprintf(text, sizeof text, "n1 %.7g n2 %.7g thickness %.7g nm angle %.5f deg wavelength %.6g nm", n1[i],
                  n2[i], thickness_nm, std::acos(cos_i) * 180 / std::numbers::pi, wavelength_nm[i]);
    return text;
  }
};

inline double as_float(double value) { return static_cast<float>(value); }

inline double cosine_of_degrees(double angle_deg) {
  return as_float(std::sin((90 - angle_deg) * std::numbers::pi / 180));
}

inline void spread_wavelengths(FilmCase& film, double shift) {
  for (int i = 0; i < lanes; ++i) film.wavelength_nm[i] = as_float(360 + 470 * (i + shift) / lanes);
}

inline void constant_indices(FilmCase& film, double n1, double n2) {
  for (int i = 0; i < lanes; ++i) film.n1[i] = as_float(n1), film.n2[i] = std::max(film.n1[i], as_float(n2));
}

// Outside index 1 and 1.333, film index from 1.0001 (or the outside's) to 4, 0..2000 nm, 0..89.9 degrees.
inline FilmCase random_film(Pcg32& random) {
  FilmCase film;
  spread_wavelengths(film, random.uniform());
  const double n1 = random() & 1 ? 1.333 : 1;
  const double least = std::max(n1, 1.0001);
  constant_indices(film, n1, least + (4 - least) * std::pow(random.uniform(), 2));  // soap is nearer to 1 than to 4
  film.thickness_nm = as_float(random() % 8 ? random.uniform(0, 2000) : random.uniform(0, 20));
  film.cos_i = cosine_of_degrees(random() % 4 ? random.uniform(0, 89.9) : 89.9 - 10 * std::pow(random.uniform(), 2));
  return film;
}

// The same with indices that differ from lane to lane, outside as well.
inline FilmCase random_dispersive_film(Pcg32& random) {
  FilmCase film = random_film(random);
  for (int i = 0; i < lanes; ++i) {
    film.n1[i] = as_float(film.n1[i] * random.uniform(1, 1.05));
    film.n2[i] = std::max(film.n1[i], as_float(film.n2[i] * random.uniform(0.98, 1.05)));
  }
  return film;
}

// Every combination of these values.
template <class Visit>
void visit_film_grid(const Visit& visit) {
  for (const double n1 : {1.0, 1.333})
    for (const double n2 : {1.0001, 1.001, 1.05, 1.333, 1.3334, 1.34, 1.5, 1.9, 2.5, 3.2, 4.0}) {
      if (n2 < n1) continue;
      for (int step = 0; step <= 40; ++step)
        for (const double angle_deg : {0.0, 1e-3, 5.0, 20.0, 36.87, 45.0, 53.13, 56.31, 63.4, 70.0, 75.96, 80.0, 85.0,
                                       88.0, 89.0, 89.5, 89.8, 89.9}) {
          FilmCase film;
          spread_wavelengths(film, step / 41.0);
          constant_indices(film, n1, n2);
          film.thickness_nm = 50 * step;
          film.cos_i = cosine_of_degrees(angle_deg);
          visit(film);
        }
    }
}

// The largest error seen and where. Not-a-numbers count as infinite.
class Worst {
 public:
  template <class Where>
  void see(double error, const Where& where) {
    if (error <= error_) return;
    if (std::isnan(error)) error = INFINITY;
    error_ = error;
    where_ = where();
  }
  double error() const { return error_; }

  // Fails beyond the limit; prints and records the figure in any case.
  void expect_within(double limit, const char* what) const {
    EXPECT_LE(error_, limit) << what << " at " << where_;
    std::printf("[ measured ] %-28s %.3g of %.3g at %s\n", what, error_, limit, where_.c_str());
    testing::Test::RecordProperty(what, testing::PrintToString(error_));
  }

 private:
  double error_ = 0;
  std::string where_ = "no case";
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
