// Coherent stacks on packets, and what the machine could do at best. No packet shows here: the source is compiled for
// each kind of machine. Every loop over stacks returns the mean of R_s + R_p, so that their results can be compared.
#pragma once

#include <memory>
#include <vector>

#include "shabon/optics/stack.h"

namespace shabon::bench {

// All angles by all wavelengths.
struct StackCases {
  optics::Stack stack;
  std::vector<double> cos_i;
  std::vector<double> wavelengths_nm;  // a multiple of 16
};

class StackPackets {
 public:
  explicit StackPackets(const StackCases& cases);
  ~StackPackets();
  StackPackets(StackPackets&&) = default;

  double in_float() const;  // float alone, whatever the error
  double in_double() const;
  double as_needed() const;        // R and T within 5e-6
  double stokes() const;           // both Mueller blocks within 5e-6
  double share_in_double() const;  // of the packets, when as needed

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

// Runs fused multiply-adds that do not wait for each other, on registers of the kernel's width; returns their result
// and counts two operations for each lane of each.
double multiply_add_float(double& operations);
double multiply_add_double(double& operations);

// Operations of the kernel for each layer and wavelength, both polarisations, counted from stack_layers.h: additions
// and multiplications of the algebra and of its polynomials. In float those in double count twice: they take two
// registers.
struct StackOperations {
  double in_float, in_double;
};
StackOperations operations_per_constant_layer();
StackOperations operations_per_dispersive_layer();

}  // namespace shabon::bench
