#include "shabon/film/flow/metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "shabon/film/flow/sweeps.h"
#include "shabon/math/normal_to.h"

namespace shabon::film {

namespace {

Numbers scaled(const Numbers& values, double factor) {
  Numbers result = values;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= factor;
  return result;
}

Numbers inverse(const Numbers& values) {
  Numbers result = values;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = 1 / values[i];
  return result;
}

}  // namespace

Metric::Metric(std::shared_ptr<const SphereGrid> unit_sphere, double radius_m)
    : grid(std::move(unit_sphere)),
      radius(radius_m),
      area(scaled(grid->area, radius_m * radius_m)),
      per_area(inverse(area)),
      per_triangle_area(inverse(scaled(grid->triangle_area, radius_m * radius_m))),
      length(scaled(grid->length, radius_m)),
      per_length(inverse(length)),
      distance(scaled(grid->distance, radius_m)),
      per_distance(inverse(distance)) {
  const auto all = distance.values();
  least_distance = *std::min_element(all.begin(), all.end());
}

double dot(const double* a, const double* b, Index count) {
  constexpr Index block = 8;
  std::array<double, block> sums{};
  Index i = 0;
  for (; i + block <= count; i += block)
    for (Index j = 0; j < block; ++j) sums[static_cast<std::size_t>(j)] += a[i + j] * b[i + j];
  for (Index j = 0; i < count; ++i, ++j) sums[static_cast<std::size_t>(j)] += a[i] * b[i];
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

double sum(const double* a, Index count) {
  constexpr Index block = 8;
  std::array<double, block> sums{};
  Index i = 0;
  for (; i + block <= count; i += block)
    for (Index j = 0; j < block; ++j) sums[static_cast<std::size_t>(j)] += a[i + j];
  for (Index j = 0; i < count; ++i, ++j) sums[static_cast<std::size_t>(j)] += a[i];
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

double integral(const Metric& metric, const Numbers& cells) {
  return dot(metric.area.data(), cells.data(), metric.topology().cells);
}

void divergence(const Metric& metric, const Numbers& along, Numbers& cells) {
  const double *u = along.data(), *length = metric.length.data(), *per_area = metric.per_area.data();
  double* out = cells.data();
  sweep_cells(metric.topology(), [=](const auto& a) {
    double sum = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      sum += a.template sign<k>() * (length[e] * u[e]);
    });
    out[a.c] = sum * per_area[a.c];
  });
}

void gradient(const Metric& metric, const Numbers& cells, Numbers& along) {
  const double *value = cells.data(), *per_distance = metric.per_distance.data();
  double* out = along.data();
  sweep_owners(metric.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      out[e] = (value[a.template cell<k>()] - value[a.c]) * per_distance[e];
    });
  });
}

void curl(const Metric& metric, const Numbers& along, Numbers& triangles) {
  const double *u = along.data(), *d = metric.distance.data(), *per_area = metric.per_triangle_area.data();
  double* out = triangles.data();
  const Index n = metric.topology().owned;
  sweep_owners(metric.topology(), [=](const auto& a) {
    const Index c = a.c, far0 = a.template far_edge<0>(), far1 = a.template far_edge<1>();
    const double one = d[c] * u[c], two = d[n + c] * u[n + c], three = d[2 * n + c] * u[2 * n + c];
    out[c] = (one - two + a.template far_sign<0>() * (d[far0] * u[far0])) * per_area[c];
    out[n + c] = (two - three + a.template far_sign<1>() * (d[far1] * u[far1])) * per_area[n + c];
  });
}

void from_stream(const Metric& metric, const Numbers& triangles, Numbers& along) {
  const double *stream = triangles.data(), *per_length = metric.per_length.data();
  double* out = along.data();
  sweep_owners(metric.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      out[e] = (stream[a.template tri<k - 1>()] - stream[a.template tri<k>()]) * per_length[e];
    });
  });
}

void cell_terms(const Metric& metric, const Numbers& along, Numbers& kinetic, Padded<float>& turned) {
  const double *u = along.data(), *length = metric.length.data(), *distance = metric.distance.data();
  const double* per_area = metric.per_area.data();
  const float* kite = metric.grid->kite.data();
  double* energy = kinetic.data();
  float* turn = turned.data();
  const Index cells = metric.topology().cells;
  sweep_cells(metric.topology(), [=](const auto& a) {
    const Index c = a.c;
    double out[slots], share[slots], total = 0, twice_energy = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      const double flux = length[e] * u[e];
      out[k] = a.template sign<k>() * flux;
      twice_energy += std::abs(a.template sign<k>()) * (flux * (distance[e] * u[e]));
      total += out[k];
      share[k] = static_cast<double>(kite[k * cells + c]);
    });
    energy[c] = twice_energy * 0.25 * per_area[c];
    // The sum for slot 0 with the shares between it and each other slot; the others follow from it one by one.
    double passed = share[0], sum = (0.5 - passed) * out[1];
    passed += share[1], sum += (0.5 - passed) * out[2];
    passed += share[2], sum += (0.5 - passed) * out[3];
    passed += share[3], sum += (0.5 - passed) * out[4];
    passed += share[4], sum += (0.5 - passed) * out[5];
    turn[c] = static_cast<float>(sum);
    for (int k = 0; k + 1 < slots; ++k) {
      sum += share[k] * total - 0.5 * (out[k] + out[k + 1]);
      turn[(k + 1) * cells + c] = static_cast<float>(sum);
    }
  });
}

void across(const Metric& metric, const Padded<float>& turned, Numbers& left) {
  const float* turn = turned.data();
  const double* per_distance = metric.per_distance.data();
  double* out = left.data();
  const Index cells = metric.topology().cells;
  sweep_owners(metric.topology(), [=](const auto& a) {
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>();
      out[e] = static_cast<double>(turn[k * cells + a.c] - turn[a.template across<k>(cells)]) * per_distance[e];
    });
  });
}

std::vector<math::Vec3d> cell_vectors(const Metric& metric, const Numbers& along) {
  using math::Vec3d;
  const SphereGrid& grid = *metric.grid;
  std::vector<Vec3d> result;
  result.reserve(grid.centres.size());
  for (Index c = 0; c < grid.topology.cells; ++c) {
    const CellAround around = grid.topology.around(c);
    const Vec3d here = grid.centres[static_cast<std::size_t>(c)];
    const Vec3d x = math::any_normal_to(here), y = math::cross(here, x);
    double xx = 0, xy = 0, yy = 0, xu = 0, yu = 0;
    for (std::size_t k = 0; k < slots; ++k) {
      if (around.sign[k] == 0) continue;
      const Vec3d towards = math::normalize(grid.centres[static_cast<std::size_t>(around.cell[k])] - here);
      const double nx = math::dot(towards, x), ny = math::dot(towards, y);
      const double u = around.sign[k] * along[static_cast<std::size_t>(around.edge[k])];
      xx += nx * nx, xy += nx * ny, yy += ny * ny, xu += nx * u, yu += ny * u;
    }
    const double scale = 1 / (xx * yy - xy * xy);
    result.push_back(x * ((xu * yy - yu * xy) * scale) + y * ((yu * xx - xu * xy) * scale));
  }
  return result;
}

}  // namespace shabon::film
