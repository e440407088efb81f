#include "shabon/film/flow/elastic_solver.h"

#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

namespace {

// Mean of L's diagonal over the area's, above which a multigrid cycle is worth its time (bench/film).
constexpr double stiff_ratio = 12;

}  // namespace

ElasticSolver::ElasticSolver(const Metric& metric)
    : metric_(metric),
      multigrid_(metric),
      per_diagonal_(metric.grid->cell_numbers(1)),
      residual_(metric.grid->cell_numbers()),
      direction_(residual_),
      image_(residual_),
      scaled_(residual_) {}

void ElasticSolver::multiply(const Numbers& coupling, const Numbers& x, Numbers& out) {
  const double *k_of = coupling.data(), *in = x.data(), *area = metric_.area.data();
  double* result = out.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    const double here = in[c];
    double image = area[c] * here;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      image += k_of[a.template edge<k>()] * (here - in[a.template cell<k>()]);
    });
    result[c] = image;
  });
}

void ElasticSolver::set_diagonal(const Numbers& coupling) {
  const double *k_of = coupling.data(), *area = metric_.area.data();
  double* per_diagonal = per_diagonal_.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    double diagonal = area[a.c];
    each_slot([&](auto slot) { diagonal += k_of[a.template edge<slot.value>()]; });
    per_diagonal[a.c] = 1 / diagonal;
  });
}

bool ElasticSolver::is_stiff(const Numbers& coupling) const {
  const double couplings = sum(coupling.data(), metric_.topology().edges);
  return 2 * couplings > stiff_ratio * sum(metric_.area.data(), metric_.topology().cells);
}

void ElasticSolver::precondition(bool stiff) {
  if (stiff) return multigrid_.apply(residual_, scaled_);
  const double *r = residual_.data(), *per_diagonal = per_diagonal_.data();
  double* z = scaled_.data();
  const Index cells = metric_.topology().cells;
  for (Index c = 0; c < cells; ++c) z[c] = r[c] * per_diagonal[c];
}

int ElasticSolver::solve(const Numbers& coupling, const Numbers& b, Numbers& x_numbers, double residual, int most) {
  const Index cells = metric_.topology().cells;
  const bool stiff = is_stiff(coupling);
  if (stiff)
    multigrid_.set(coupling);
  else
    set_diagonal(coupling);
  multiply(coupling, x_numbers, image_);
  double *r = residual_.data(), *p = direction_.data(), *q = image_.data(), *z = scaled_.data(), *x = x_numbers.data();
  const double* right = b.data();
  for (Index c = 0; c < cells; ++c) r[c] = right[c] - q[c];
  const double enough = residual * residual;
  double rz = 1;
  for (int n = 0; n <= most; ++n) {
    const double rr = dot(r, r, cells);
    if (rr <= enough) return n;
    if (!(rr < 1e300)) return -1;
    precondition(stiff);
    const double next = dot(r, z, cells), beta = n == 0 ? 0 : next / rz;
    rz = next;
    for (Index c = 0; c < cells; ++c) p[c] = z[c] + beta * p[c];
    multiply(coupling, direction_, image_);
    const double alpha = rz / dot(p, q, cells);
    for (Index c = 0; c < cells; ++c) x[c] += alpha * p[c], r[c] -= alpha * q[c];
  }
  return -1;
}

}  // namespace shabon::film
