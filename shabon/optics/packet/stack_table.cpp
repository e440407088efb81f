#include "shabon/optics/packet/stack_table.h"

#include <algorithm>
#include <complex>

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

// Wavelengths up to a multiple of stack_row_multiple, and the index of medium 1 at each.
struct Sampling {
  std::vector<double> wavelengths_nm;
  std::vector<double> n1;
  bool constant_n1;
};

Sampling sampling_of(const Medium& medium1, std::span<const double> wavelengths_nm) {
  Sampling result{{wavelengths_nm.begin(), wavelengths_nm.end()}, {}, medium1.is_constant()};
  result.wavelengths_nm.resize(
      (wavelengths_nm.size() + stack_row_multiple - 1) / stack_row_multiple * stack_row_multiple,
      wavelengths_nm.back());
  for (const double wavelength_nm : result.wavelengths_nm) result.n1.push_back(medium1.index(wavelength_nm).real());
  return result;
}

template <class T>
SquaredRows<T> squared_rows(const std::vector<Complex>& n, bool lossless) {
  const std::size_t size = n.size(), size_im = lossless ? 0 : size;
  SquaredRows<T> rows{WavelengthRow<T>(size), WavelengthRow<T>(size_im), WavelengthRow<T>(size),
                      WavelengthRow<T>(size_im)};
  for (std::size_t i = 0; i < size; ++i) {
    const Complex squared = n[i] * n[i], inverse = 1.0 / squared;
    rows.n_squared[i] = static_cast<T>(squared.real()), rows.inverse[i] = static_cast<T>(inverse.real());
    if (lossless) continue;
    rows.n_squared_im[i] = static_cast<T>(squared.imag()), rows.inverse_im[i] = static_cast<T>(inverse.imag());
  }
  return rows;
}

void fill(MediumRows& rows, const Medium& medium, const Sampling& at) {
  std::vector<Complex> n;
  for (const double wavelength_nm : at.wavelengths_nm) n.push_back(medium.index(wavelength_nm));
  rows.lossless = medium.is_lossless();
  rows.constant = medium.is_constant() && at.constant_n1;
  rows.step = WavelengthRow<double>(n.size());
  if (!rows.lossless) rows.step_im = WavelengthRow<double>(n.size());
  for (std::size_t i = 0; i < n.size(); ++i) {
    const Complex step = (n[i] - at.n1[i]) * (n[i] + at.n1[i]);
    rows.step[i] = step.real();
    if (!rows.lossless) rows.step_im[i] = step.imag();
    rows.least_step = i == 0 ? step.real() : std::min(rows.least_step, step.real());
  }
  rows.in_float = squared_rows<float>(n, rows.lossless);
  rows.in_double = squared_rows<double>(n, rows.lossless);
}

}  // namespace

StackTable::StackTable(const Stack& stack, std::span<const double> wavelengths_nm)
    : wavelength_count(wavelengths_nm.size()) {
  const Sampling at = sampling_of(stack.incidence, wavelengths_nm);
  row_size = at.wavelengths_nm.size();
  half_turns_per_nm = WavelengthRow<double>(row_size);
  for (std::size_t i = 0; i < row_size; ++i) half_turns_per_nm[i] = 2 / at.wavelengths_nm[i];
  const double least_n1 = *std::min_element(at.n1.begin(), at.n1.end());
  least_n1_squared = least_n1 * least_n1;
  fill(incidence, stack.incidence, at);
  fill(exit, stack.exit, at);
  for (std::size_t i = 0; i < row_size; ++i)
    equal_outer_media = equal_outer_media && exit.lossless && exit.step[i] == 0;
  std::vector<const Medium*> known;
  for (const Layer& layer : stack.layers) {
    const auto same = [&](const Medium* medium) { return *medium == layer.medium; };
    const auto found = std::find_if(known.begin(), known.end(), same);
    layers.push_back({static_cast<std::size_t>(found - known.begin()), layer.thickness_nm});
    if (found != known.end()) continue;
    known.push_back(&layer.medium);
    fill(media.emplace_back(), layer.medium, at);
    lossless = lossless && media.back().lossless;
  }
}

}  // namespace shabon::optics
