// The film events that all film loops compute: angles and thicknesses spread evenly and independently.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/scene/scene.h"

namespace shabon::bench {

inline constexpr int event_count = 512;  // with their inputs they fit the first-level cache
inline constexpr int block_size = 8;     // events whose angles the renderer prepares together

struct FilmEvents {
  alignas(64) std::array<double, event_count> cos_i, thickness_nm;

  FilmEvents() {
    constexpr double most_incidence = 85 * std::numbers::pi / 180, thinnest_nm = 150, thickest_nm = 900;
    constexpr double step[2] = {0.7548776662466927, 0.5698402909980532};  // the R2 sequence (Roberts 2018)
    for (int i = 0; i < event_count; ++i) {
      const double u = i * step[0] - std::floor(i * step[0]), v = i * step[1] - std::floor(i * step[1]);
      cos_i[static_cast<std::size_t>(i)] = std::cos(most_incidence * u);
      thickness_nm[static_cast<std::size_t>(i)] = thinnest_nm + (thickest_nm - thinnest_nm) * v;
    }
  }
};

// The wavelength comb of a block: neighbours share one, as the samples of a tile do.
constexpr std::size_t comb_of_block(int block) { return static_cast<std::size_t>(block / 8 * 37 % 64); }

}  // namespace shabon::bench
