#include "shabon/film/flow/momentum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

namespace {

constexpr double stable_share = 0.9;  // of the longest stable viscous step

}  // namespace

// Gershgorin: no eigenvalue exceeds twice the largest diagonal of curl and its adjoint, at the corners.
Momentum::Momentum(const Metric& metric)
    : metric_(metric),
      turned_(metric.grid->slot_numbers()),
      kinetic_(metric.grid->cell_numbers()),
      vorticity_(metric.grid->triangle_numbers()),
      one_(metric.grid->edge_numbers()),
      two_(one_) {
  Numbers diagonal = vorticity_;
  for (Index c = 0; c < metric.topology().owned; ++c) {
    const CellAround around = metric.topology().around(c);
    for (std::size_t k = 1; k <= owned_slots; ++k) {
      const auto e = static_cast<std::size_t>(around.edge[k]);
      const double weight = metric.distance[e] * metric.per_length[e];
      for (const Index t : {around.tri[k], around.tri[k - 1]})
        diagonal[static_cast<std::size_t>(t)] += weight * metric.per_triangle_area[static_cast<std::size_t>(t)];
    }
  }
  const auto all = diagonal.values();
  stiffest_per_m2_ = 2 * *std::max_element(all.begin(), all.end());
}

int Momentum::viscous_stages(double step_s, double viscosity_m2_s) const {
  const double steps = step_s * viscosity_m2_s * stiffest_per_m2_ / (2 * stable_share);  // of the explicit scheme
  return std::max(1, static_cast<int>(std::ceil((std::sqrt(1 + 8 * steps) - 1) / 2)));
}

namespace {

// Vorticity times the velocity to the left, less the slope of the kinetic energy: of one edge.
struct Advection {
  const double *energy, *spin, *per_distance;
  const float* turn;
  Index cells;

  template <int k, class Around>
  double left(const Around& a) const {
    return static_cast<double>(turn[k * cells + a.c] - turn[a.template across<k>(cells)]) *
           per_distance[a.template edge<k>()];
  }
  template <int k, class Around>
  double rate(const Around& a, double left) const {
    const double spin_here = 0.5 * (spin[a.template tri<k>()] + spin[a.template tri<k - 1>()]);
    return spin_here * left - (energy[a.template cell<k>()] - energy[a.c]) * per_distance[a.template edge<k>()];
  }
};

}  // namespace

// next = base + share_s (advection of `now` + push).
void Momentum::early_stage(const Numbers& base, const Numbers& now, const Numbers& push, double share_s,
                           Numbers& next) {
  cell_terms(metric_, now, kinetic_, turned_);
  curl(metric_, now, vorticity_);
  const Advection advection{kinetic_.data(), vorticity_.data(), metric_.per_distance.data(), turned_.data(),
                            metric_.topology().cells};
  const double *u = base.data(), *pushed = push.data();
  double* out = next.data();
  sweep_owners(metric_.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      out[e] = u[e] + share_s * (advection.rate<k>(a, advection.left<k>(a)) + pushed[e]);
    });
  });
}

void Momentum::last_stage(const Numbers& base, const Numbers& now, double share_s, Numbers& next, Numbers& left) {
  cell_terms(metric_, now, kinetic_, turned_);
  curl(metric_, now, vorticity_);
  const Advection advection{kinetic_.data(), vorticity_.data(), metric_.per_distance.data(), turned_.data(),
                            metric_.topology().cells};
  const double* u = base.data();
  double *out = next.data(), *left_of = left.data();
  sweep_owners(metric_.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      const double to_left = advection.left<k>(a);
      out[e] = u[e] + share_s * advection.rate<k>(a, to_left);
      left_of[e] = to_left;
    });
  });
}

// next = of_now now + of_before before + share_m2 (k x grad curl + 2 / R^2) now.
void Momentum::viscous_stage(const Numbers& now, double of_now, const Numbers& before, double of_before,
                             double share_m2, Numbers& next) {
  curl(metric_, now, vorticity_);
  const double *u = now.data(), *old = before.data(), *spin = vorticity_.data();
  const double* per_length = metric_.per_length.data();
  double* out = next.data();
  const double here = of_now + share_m2 * 2 / (metric_.radius * metric_.radius);
  sweep_owners(metric_.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      const double rise = (spin[a.template tri<k>()] - spin[a.template tri<k - 1>()]) * per_length[e];
      out[e] = here * u[e] + of_before * old[e] - share_m2 * rise;
    });
  });
}

// Runge-Kutta-Legendre of first order (Meyer, Balsara, Aslam 2014): s stages are stable for (s^2 + s)/2 explicit steps.
void Momentum::diffuse(Numbers& along, double step_m2, int stages) {
  const double first = 2.0 / (stages * stages + stages);
  viscous_stage(along, 1, along, 0, first * step_m2, one_);
  for (int j = 2; j <= stages; ++j) {
    const double mu = (2.0 * j - 1) / j, nu = (1.0 - j) / j;
    viscous_stage(one_, mu, along, nu, mu * first * step_m2, two_);
    std::swap(along, one_), std::swap(one_, two_);
  }
  std::swap(along, one_);
}

void Momentum::advance(const Numbers& along, const Numbers& push, double step_s, double viscosity_m2_s,
                       Numbers& advanced, Numbers& left) {
  early_stage(along, along, push, step_s / 3, one_);
  early_stage(along, one_, push, step_s / 2, two_);
  last_stage(along, two_, step_s, advanced, left);
  if (viscosity_m2_s > 0) diffuse(advanced, step_s * viscosity_m2_s, viscous_stages(step_s, viscosity_m2_s));
}

}  // namespace shabon::film
