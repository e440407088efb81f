#include "shabon/film/flow/multigrid.h"

#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

Multigrid::Multigrid(const Metric& metric)
    : metric_(metric),
      diagonal_(metric.grid->cell_numbers(1)),
      residual_(metric.grid->cell_numbers()),
      direction_(residual_),
      image_(residual_),
      scaled_(residual_) {}

void Multigrid::apply(const Numbers& coupling, const Numbers& x, Numbers& out) {
  const double *k_of = coupling.data(), *in = x.data(), *area = metric_.area.data();
  double* result = out.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    const double here = in[c];
    double sum = area[c] * here;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      sum += k_of[a.template edge<k>()] * (here - in[a.template cell<k>()]);
    });
    result[c] = sum;
  });
}

int Multigrid::solve(const Numbers& coupling, const Numbers& b, Numbers& x_numbers, double residual, int most) {
  const Index cells = metric_.topology().cells;
  const double *k_of = coupling.data(), *area = metric_.area.data();
  double* diagonal = diagonal_.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    double sum = area[a.c];
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      sum += k_of[a.template edge<k>()];
    });
    diagonal[a.c] = 1 / sum;
  });
  apply(coupling, x_numbers, image_);
  double *r = residual_.data(), *p = direction_.data(), *q = image_.data(), *z = scaled_.data(), *x = x_numbers.data();
  const double* right = b.data();
  for (Index c = 0; c < cells; ++c) r[c] = right[c] - q[c], z[c] = r[c] * diagonal[c], p[c] = z[c];
  double rz = dot(r, z, cells);
  const double enough = residual * residual;
  for (int n = 0; n <= most; ++n) {
    const double rr = dot(r, r, cells);
    if (rr <= enough) return n;
    if (!(rr < 1e300)) return -1;
    apply(coupling, direction_, image_);
    const double alpha = rz / dot(p, q, cells);
    for (Index c = 0; c < cells; ++c) x[c] += alpha * p[c], r[c] -= alpha * q[c], z[c] = r[c] * diagonal[c];
    const double next = dot(r, z, cells), beta = next / rz;
    rz = next;
    for (Index c = 0; c < cells; ++c) p[c] = z[c] + beta * p[c];
  }
  return -1;
}

}  // namespace shabon::film
