#include "shabon/optics/reference/fresnel.h"

#include <cmath>

namespace shabon::optics {

using Complex = std::complex<double>;

Complex forward_root(Complex square) {
  if (square.imag() == 0)
    return square.real() < 0 ? Complex(0, std::sqrt(-square.real())) : Complex(std::sqrt(square.real()), 0);
  // Both real and imaginary part of a forward wave are positive, unless the first medium absorbs; then the larger is.
  const Complex root = std::sqrt(square);
  return root.real() + root.imag() < 0 ? -root : root;
}

Complex normal_index(Complex n1, Incidence incidence, Complex n) {
  if (n == n1) return n1 * incidence.cos_i;
  // n^2 c^2 = (n - n1)(n + n1) + (n1 cos_i)^2 = (n - n1 sin_i)(n + n1 sin_i): whichever cancels less, the first towards
  // grazing incidence, the second towards normal incidence, where the first is nearly n1^2 - n1^2 for a small n.
  const Complex n1_c1 = n1 * incidence.cos_i, n1_s1 = n1 * incidence.sin_i, difference = (n - n1) * (n + n1);
  const bool towards_grazing = norm(difference) + norm(n1_c1 * n1_c1) < norm(n * n) + norm(n1_s1 * n1_s1);
  return forward_root(towards_grazing ? difference + n1_c1 * n1_c1 : (n - n1_s1) * (n + n1_s1));
}

Complex refracted_cosine(Complex n1, Incidence incidence, Complex n) {
  return n == n1 ? Complex(incidence.cos_i) : normal_index(n1, incidence, n) / n;
}

InterfaceAmplitudes fresnel(Complex n1, Complex c1, Complex n2, Complex c2) {
  const Complex sum_s = n1 * c1 + n2 * c2;
  const Complex sum_p = n2 * c1 + n1 * c2;
  if (sum_s == 0.0 || sum_p == 0.0) return {0, 0, 1, 1};
  return {
      (n1 * c1 - n2 * c2) / sum_s,  // (2)
      (n2 * c1 - n1 * c2) / sum_p,  // (3)
      2.0 * n1 * c1 / sum_s,        // (4)
      2.0 * n1 * c1 / sum_p,        // (5)
  };
}

}  // namespace shabon::optics
