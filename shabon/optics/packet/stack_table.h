// A coherent stack at many wavelengths: all that the packet kernel needs to know of it, made once. Plain numbers in
// rows over the wavelengths, so that this header knows no packets.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shabon/optics/stack.h"

namespace shabon::optics {

// Rows end at a multiple of this; the last wavelength is repeated.
inline constexpr std::size_t stack_row_multiple = 16;

// A row of numbers that starts at a multiple of 64 bytes, as wide registers like it.
template <class T>
class WavelengthRow {
 public:
  WavelengthRow() = default;
  explicit WavelengthRow(std::size_t size) : blocks_((size + block - 1) / block) {}
  T& operator[](std::size_t i) { return blocks_[i / block].value[i % block]; }
  const T& operator[](std::size_t i) const { return blocks_[i / block].value[i % block]; }

 private:
  static constexpr std::size_t block = 64 / sizeof(T);
  struct alignas(64) Block {
    T value[block];
  };
  std::vector<Block> blocks_;
};

// n^2 and 1/n^2 in the kernel's number type; the imaginary rows are empty without absorption.
template <class T>
struct SquaredRows {
  WavelengthRow<T> n_squared, n_squared_im, inverse, inverse_im;
};

// The medium of layers or of a half-space.
struct MediumRows {
  bool lossless = true;
  bool constant = true;                 // neither its index nor that of medium 1 depends on the wavelength
  double least_step = 0;                // the least of the row of real parts
  WavelengthRow<double> step, step_im;  // n^2 - n1^2, in which nothing cancels later at grazing incidence
  SquaredRows<float> in_float;
  SquaredRows<double> in_double;

  template <class T>
  const SquaredRows<T>& squared() const {
    if constexpr (sizeof(T) == 4)
      return in_float;
    else
      return in_double;
  }
};

struct LayerOfTable {
  std::size_t medium;  // index into StackTable::media
  double thickness_nm;
};

struct StackTable {
  // Vacuum wavelengths > 0 nm, at least one. The stack's layers are taken as coherent; medium 1 must not absorb.
  StackTable(const Stack& stack, std::span<const double> wavelengths_nm);

  std::size_t wavelength_count = 0;  // as asked for
  std::size_t row_size = 0;          // rounded up to stack_row_multiple
  bool lossless = true;              // no layer absorbs
  bool equal_outer_media = true;     // at all wavelengths
  double least_n1_squared = 1;
  WavelengthRow<double> half_turns_per_nm;  // 2/wavelength
  MediumRows incidence, exit;
  std::vector<MediumRows> media;  // each once, however many layers it has
  std::vector<LayerOfTable> layers;
};

}  // namespace shabon::optics
