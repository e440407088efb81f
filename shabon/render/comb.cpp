#include "shabon/render/comb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shabon::render {

namespace {

using Lanes = std::array<double, lane_count>;

// Solves M x = b for a symmetric positive definite M by Cholesky; `ridge` keeps lamps that are combinations of others,
// or black, from dividing by zero.
std::vector<double> solve_symmetric(std::vector<std::vector<double>> m, std::vector<double> b) {
  const std::size_t n = b.size();
  double trace = 0;
  for (std::size_t i = 0; i < n; ++i) trace += m[i][i];
  const double ridge = std::max(1e-13 * trace, std::numeric_limits<double>::min());
  for (std::size_t i = 0; i < n; ++i) m[i][i] += ridge;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
    m[j][j] = std::sqrt(std::max(m[j][j], ridge));
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
      m[i][j] /= m[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= m[i][k] * b[k];
    b[i] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= m[k][i] * b[k];
    b[i] /= m[i][i];
  }
  return b;
}

double exact_sum(const color::Spectrum& lamp, std::span<const double, color::spectrum_size> response) {
  double sum = 0;
  for (std::size_t i = 0; i < lamp.size(); ++i) sum += lamp[i] * response[i];
  return sum;
}

// The smallest change of the weights after which every lamp comes out exactly, spread evenly over the lanes: a change
// in proportion to the weights would leave a bias three times as large in the mean over all combs.
void correct(Lanes& weight, const std::vector<Lanes>& lamp_lanes, const std::vector<double>& exact) {
  const std::size_t n = lamp_lanes.size();
  std::vector<std::vector<double>> normal(n, std::vector<double>(n));
  std::vector<double> missing(n);
  for (std::size_t a = 0; a < n; ++a) {
    missing[a] = exact[a];
    for (int i = 0; i < lane_count; ++i) missing[a] -= lamp_lanes[a][i] * weight[i];
    for (std::size_t b = 0; b < n; ++b)
      for (int i = 0; i < lane_count; ++i) normal[a][b] += lamp_lanes[a][i] * lamp_lanes[b][i];
  }
  const std::vector<double> factor = solve_symmetric(normal, missing);
  for (int i = 0; i < lane_count; ++i)
    for (std::size_t a = 0; a < n; ++a) weight[i] += lamp_lanes[a][i] * factor[a];
}

}  // namespace

double at_wavelength(std::span<const double, color::spectrum_size> spectrum, double wavelength_nm) {
  const double position = std::clamp(wavelength_nm - color::first_nm, 0.0, double(color::spectrum_size - 1));
  const int left = std::min(static_cast<int>(position), color::spectrum_size - 2);
  const double share = position - left;
  return spectrum[static_cast<std::size_t>(left)] * (1 - share) + spectrum[static_cast<std::size_t>(left + 1)] * share;
}

std::vector<Comb> wavelength_combs(const color::Observer& observer, std::span<const color::Spectrum> lamps) {
  // Each of the 471 table values stands for one nanometre, so the sum covers 359.5 to 830.5 nm.
  constexpr double spacing_nm = double(color::spectrum_size) / lane_count;
  constexpr double start_nm = color::first_nm - 0.5;
  const std::array responses{observer.x, observer.y, observer.z};
  std::vector<Comb> combs(comb_count);
  for (int shift = 0; shift < comb_count; ++shift) {
    Comb& comb = combs[static_cast<std::size_t>(shift)];
    for (int i = 0; i < lane_count; ++i) {
      comb.wavelength_nm[i] = start_nm + (i + (shift + 0.5) / comb_count) * spacing_nm;
      for (std::size_t c = 0; c < 3; ++c)
        comb.weight[c][i] = spacing_nm * at_wavelength(responses[c], comb.wavelength_nm[i]);
    }
    std::vector<Lanes> lamp_lanes(lamps.size());
    for (std::size_t a = 0; a < lamps.size(); ++a)
      for (int i = 0; i < lane_count; ++i) lamp_lanes[a][i] = at_wavelength(lamps[a], comb.wavelength_nm[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<double> exact(lamps.size());
      for (std::size_t a = 0; a < lamps.size(); ++a) exact[a] = exact_sum(lamps[a], responses[c]);
      correct(comb.weight[c], lamp_lanes, exact);
      correct(comb.weight[c], lamp_lanes, exact);  // again: what the ridge left over
    }
  }
  return combs;
}

}  // namespace shabon::render
