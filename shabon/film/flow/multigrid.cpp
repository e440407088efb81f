#include "shabon/film/flow/multigrid.h"

#include <algorithm>

#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

namespace {

constexpr float damping_share = 0.9F;
constexpr int coarsest_level = 2;
constexpr int coarsest_sweeps = 4;  // their mass is most of the diagonal there

std::int32_t narrow(Index i) { return static_cast<std::int32_t>(i); }

// (area + L) x of one cell.
template <class Around>
[[gnu::always_inline]] inline float product(const Around& a, const float* mass, const float* coupling, const float* x) {
  const float here = x[a.c];
  float sum = mass[a.c] * here;
  each_slot([&](auto slot) {
    constexpr int k = slot.value;
    sum += coupling[a.template edge<k>()] * (here - x[a.template cell<k>()]);
  });
  return sum;
}

}  // namespace

Multigrid::Multigrid(const Metric& metric) {
  const int finest = metric.topology().level;
  for (int level = finest; level >= std::min(coarsest_level, finest); --level) {
    Level& made = levels_.emplace_back();
    made.topology = level == finest ? metric.topology() : make_topology(level);
    const std::size_t pad = made.topology.pad();
    made.mass = Floats(static_cast<std::size_t>(made.topology.cells), pad);
    made.coupling = Floats(static_cast<std::size_t>(made.topology.edges), pad);
    made.damping = made.right = made.value = made.next = made.mass;
  }
  for (std::size_t c = 0; c < levels_[0].mass.size(); ++c) levels_[0].mass[c] = static_cast<float>(metric.area[c]);
  for (std::size_t n = 0; n + 1 < levels_.size(); ++n) {
    link(levels_[n], levels_[n + 1]);
    Level& coarse = levels_[n + 1];
    for (std::size_t c = 0; c < coarse.mass.size(); ++c) {
      const auto& cells = coarse.finer_cells[c];
      for (std::size_t k = 0; k < cells.size(); ++k)
        coarse.mass[c] += (k == 0 ? 1.0F : 0.5F) * levels_[n].mass[static_cast<std::size_t>(cells[k])];
    }
  }
}

void Multigrid::link(Level& fine, Level& coarse) {
  const GridTopology &above = coarse.topology, &below = fine.topology;
  const auto place = [&](Index c) {  // of a coarse cell on the fine level
    if (c >= above.owned) return below.owned + (c - above.owned);
    const Index i = c % above.m + 1, j = c / above.m % above.m;
    return panel_cell(below.m, static_cast<int>(c / (above.m * above.m)), 2 * i, 2 * j);
  };
  const Index nothing = below.cells;  // zero: the room behind the cells is never written
  for (Index c = 0; c < above.cells; ++c) {
    const CellAround around = below.around(place(c));
    auto& cells = coarse.finer_cells.emplace_back();
    cells[0] = narrow(place(c));
    for (std::size_t k = 0; k < slots; ++k) cells[k + 1] = narrow(around.sign[k] == 0 ? nothing : around.cell[k]);
  }
  coarse.finer_edges.resize(static_cast<std::size_t>(above.edges));
  for (Index c = 0; c < above.owned; ++c) {
    const CellAround here = above.around(c), fine_here = below.around(place(c));
    for (std::size_t k = 1; k <= owned_slots; ++k) {
      const CellAround middle = below.around(fine_here.cell[k]);
      auto& halves = coarse.finer_edges[static_cast<std::size_t>(here.edge[k])];
      halves = {narrow(fine_here.edge[k]), narrow(fine_here.edge[k])};
      for (std::size_t other = 0; other < slots; ++other)
        if (middle.sign[other] != 0 && middle.cell[other] == place(here.cell[k]))
          halves[1] = narrow(middle.edge[other]);
    }
  }
  for (const Index c : below.seam) {
    if (c >= below.owned) {
      const auto pole = narrow(above.owned + (c - below.owned));
      fine.seam_parents.push_back({pole, pole});
      continue;
    }
    const auto panel = static_cast<int>(c / (below.m * below.m));
    const Index i = c % below.m + 1, j = c / below.m % below.m;
    fine.seam_parents.push_back({narrow(panel_cell(above.m, panel, i / 2, (j + 1) / 2)),
                                 narrow(panel_cell(above.m, panel, (i + 1) / 2, j / 2))});
  }
}

void Multigrid::weigh(Level& level) {
  const float *mass = level.mass.data(), *coupling = level.coupling.data();
  float* damping = level.damping.data();
  sweep_cells(level.topology, [=](const auto& a) {
    float sum = mass[a.c];
    each_slot([&](auto slot) { sum += coupling[a.template edge<slot.value>()]; });
    damping[a.c] = damping_share / sum;
  });
}

void Multigrid::set(const Numbers& coupling) {
  for (std::size_t e = 0; e < coupling.size(); ++e) levels_[0].coupling[e] = static_cast<float>(coupling[e]);
  weigh(levels_[0]);
  for (std::size_t n = 0; n + 1 < levels_.size(); ++n) {
    const float* fine = levels_[n].coupling.data();
    Level& coarse = levels_[n + 1];
    for (std::size_t e = 0; e < coarse.finer_edges.size(); ++e)
      coarse.coupling[e] = 0.5F * (fine[coarse.finer_edges[e][0]] + fine[coarse.finer_edges[e][1]]);
    weigh(coarse);
  }
}

void Multigrid::smooth_from_zero(Level& level) {
  const float *right = level.right.data(), *damping = level.damping.data();
  float* value = level.value.data();
  const Index cells = level.topology.cells;
  for (Index c = 0; c < cells; ++c) value[c] = damping[c] * right[c];
}

void Multigrid::smooth(Level& level) {
  const float *right = level.right.data(), *damping = level.damping.data(), *x = level.value.data();
  const float *mass = level.mass.data(), *coupling = level.coupling.data();
  float* next = level.next.data();
  sweep_cells(level.topology,
              [=](const auto& a) { next[a.c] = x[a.c] + damping[a.c] * (right[a.c] - product(a, mass, coupling, x)); });
  std::swap(level.value, level.next);
}

void Multigrid::restrict_residual(Level& fine, Level& coarse) {
  const float *right = fine.right.data(), *x = fine.value.data();
  const float *mass = fine.mass.data(), *coupling = fine.coupling.data();
  float* rest = fine.next.data();
  sweep_cells(fine.topology, [=](const auto& a) { rest[a.c] = right[a.c] - product(a, mass, coupling, x); });
  for (std::size_t c = 0; c < coarse.finer_cells.size(); ++c) {
    const auto& cells = coarse.finer_cells[c];
    float around = 0;
    for (std::size_t k = 1; k < cells.size(); ++k) around += rest[cells[k]];
    coarse.right[c] = rest[cells[0]] + 0.5F * around;
  }
}

// Linear between the two coarse cells on either side, or the coarse cell at the same place.
void Multigrid::add_correction(Level& fine, const Level& coarse) {
  const Index m = coarse.topology.m, rows = 10 * m;
  const float* from = coarse.value.data();
  float* rise = fine.next.data();
  for (Index row = 0; row < rows; ++row) {
    const float *here = from + row * m, *above = here + m;
    float *even = rise + 4 * row * m, *odd = even + 2 * m;
    SHABON_INDEPENDENT
    for (Index i = 0; i < m; ++i) {
      even[2 * i] = 0.5F * (here[i - 1] + here[i]);
      even[2 * i + 1] = here[i];
      odd[2 * i] = 0.5F * (here[i] + above[i - 1]);
      odd[2 * i + 1] = 0.5F * (here[i] + above[i]);
    }
  }
  for (std::size_t s = 0; s < fine.seam_parents.size(); ++s) {
    const auto [a, b] = fine.seam_parents[s];
    rise[fine.topology.seam[s]] = 0.5F * (from[a] + from[b]);
  }
  float* value = fine.value.data();
  const Index cells = fine.topology.cells;
  for (Index c = 0; c < cells; ++c) value[c] += rise[c];
}

void Multigrid::cycle(std::size_t depth) {
  Level& level = levels_[depth];
  smooth_from_zero(level);
  if (depth + 1 == levels_.size()) {
    for (int n = 1; n < coarsest_sweeps; ++n) smooth(level);
    return;
  }
  restrict_residual(level, levels_[depth + 1]);
  cycle(depth + 1);
  add_correction(level, levels_[depth + 1]);
  smooth(level);
}

void Multigrid::apply(const Numbers& residual, Numbers& image) {
  Level& finest = levels_[0];
  const Index cells = finest.topology.cells;
  const double* from = residual.data();
  float* right = finest.right.data();
  for (Index c = 0; c < cells; ++c) right[c] = static_cast<float>(from[c]);
  cycle(0);
  const float* value = finest.value.data();
  double* to = image.data();
  for (Index c = 0; c < cells; ++c) to[c] = static_cast<double>(value[c]);
}

}  // namespace shabon::film
