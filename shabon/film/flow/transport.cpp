#include "shabon/film/flow/transport.h"

#include <cmath>

#include "shabon/film/flow/sweeps.h"
#include "shabon/math/normal_to.h"

namespace shabon::film {

namespace {

using math::Vec3d;

// A frame in the tangent plane of a cell.
struct Frame {
  Vec3d x, y;
  explicit Frame(const Vec3d& centre) : x(math::any_normal_to(centre)), y(math::cross(centre, x)) {}
};

double larger(double a, double b) { return a < b ? b : a; }
double smaller(double a, double b) { return b < a ? b : a; }

}  // namespace

Transport::Transport(const Metric& metric) : metric_(metric) {
  const SphereGrid& grid = *metric.grid;
  const GridTopology& topology = grid.topology;
  const auto cells = static_cast<std::size_t>(topology.cells);
  weight_x_ = Padded<float>(cells * slots, topology.pad());
  weight_y_ = weight_x_;
  own_x_ = Padded<float>(static_cast<std::size_t>(topology.edges), topology.pad());
  own_y_ = far_x_ = far_y_ = aside_ = own_x_;
  ratio_ = slope_x_ = slope_y_ = settled_ = lowest_ = highest_ = gain_ = loss_ = grid.cell_numbers(1);
  low_ = anti_ = grid.edge_numbers();
  for (std::size_t c = 0; c < cells; ++c) {
    const CellAround around = topology.around(static_cast<Index>(c));
    const Vec3d& here = grid.centres[c];
    const Frame frame(here);
    double xx = 0, xy = 0, yy = 0, px[slots] = {}, py[slots] = {};
    for (std::size_t k = 0; k < slots; ++k) {
      if (around.sign[k] == 0) continue;
      const auto n = static_cast<std::size_t>(around.cell[k]), e = static_cast<std::size_t>(around.edge[k]);
      const Vec3d& there = grid.centres[n];
      const Vec3d towards = math::normalize(there - here * math::dot(here, there));
      const double x = math::dot(towards, frame.x), y = math::dot(towards, frame.y);
      px[k] = x * metric.distance[e], py[k] = y * metric.distance[e];
      xx += px[k] * px[k], xy += px[k] * py[k], yy += py[k] * py[k];
      if (around.sign[k] < 0) {
        far_x_[e] = static_cast<float>(-x), far_y_[e] = static_cast<float>(-y);
        continue;
      }
      own_x_[e] = static_cast<float>(x), own_y_[e] = static_cast<float>(y);
      const Vec3d middle = grid.corners[static_cast<std::size_t>(around.tri[k])] +
                           grid.corners[static_cast<std::size_t>(around.tri[(k + slots - 1) % slots])];
      aside_[e] = static_cast<float>(metric.radius / 2 * math::dot(middle, math::cross(here, towards)));
    }
    const double scale = 1 / (xx * yy - xy * xy);
    for (std::size_t k = 0; k < slots; ++k) {
      weight_x_[k * cells + c] = static_cast<float>((px[k] * yy - py[k] * xy) * scale);
      weight_y_[k * cells + c] = static_cast<float>((py[k] * xx - px[k] * xy) * scale);
    }
  }
}

void Transport::find_slopes() {
  const double* ratio = ratio_.data();
  const float *wx = weight_x_.data(), *wy = weight_y_.data();
  double *sx = slope_x_.data(), *sy = slope_y_.data();
  const Index cells = metric_.topology().cells;
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    const double here = ratio[c];
    double x = 0, y = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const double rise = ratio[a.template cell<k>()] - here;
      x += static_cast<double>(wx[k * cells + c]) * rise;
      y += static_cast<double>(wy[k * cells + c]) * rise;
    });
    sx[c] = x, sy[c] = y;
  });
}

// The monotone flux from the cell upstream, and what the better flux adds to it.
void Transport::flux_over_edges(const Crossing& crossing) {
  const double *amount = crossing.surfactant.data(), *u = crossing.along.data(), *left = crossing.left.data();
  const double *ratio = ratio_.data(), *sx = slope_x_.data(), *sy = slope_y_.data(), *d = metric_.distance.data();
  const float *ox = own_x_.data(), *oy = own_y_.data(), *fx = far_x_.data(), *fy = far_y_.data();
  const float* middle = aside_.data();
  double *low = low_.data(), *anti = anti_.data();
  const double half_s = crossing.step_s / 2;
  sweep_owners(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>(), n = a.template cell<k>();
      const double back = half_s * u[e], aside = static_cast<double>(middle[e]) - half_s * left[e];
      const double from_own = 0.5 * d[e] - back, from_far = -0.5 * d[e] - back;
      const double onx = static_cast<double>(ox[e]), ony = static_cast<double>(oy[e]);
      const double fnx = static_cast<double>(fx[e]), fny = static_cast<double>(fy[e]);
      const double rise_own = sx[c] * (from_own * onx - aside * ony) + sy[c] * (from_own * ony + aside * onx);
      const double rise_far = sx[n] * (from_far * fnx - aside * fny) + sy[n] * (from_far * fny + aside * fnx);
      const double q = amount[e], own = ratio[c], far = ratio[n];
      low[e] = q * (q >= 0 ? own : far);
      anti[e] = q * (q >= 0 ? rise_own : rise_far);
    });
  });
}

// What the monotone flux alone would leave, and the bounds of each cell with it.
void Transport::find_bounds(const Numbers& after, const Numbers& thickness) {
  const double *low = low_.data(), *h = thickness.data(), *gamma = after.data(), *ratio = ratio_.data();
  const double* per_area = metric_.per_area.data();
  double *settled = settled_.data(), *lowest = lowest_.data(), *highest = highest_.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    double out = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      out += a.template sign<k>() * low[a.template edge<k>()];
    });
    const double now = (h[c] - out * per_area[c]) / gamma[c];
    settled[c] = now;
    lowest[c] = smaller(now, ratio[c]);
    highest[c] = larger(now, ratio[c]);
  });
}

// The shares of what the better flux brings to and takes from each cell that keep within the bounds of the neighbours.
void Transport::limit(const Numbers& after) {
  const double *anti = anti_.data(), *settled = settled_.data(), *lowest = lowest_.data(), *highest = highest_.data();
  const double *gamma = after.data(), *area = metric_.area.data();
  double *gain = gain_.data(), *loss = loss_.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    double in = 0, out = 0, low = lowest[c], high = highest[c];
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const double leaves = a.template sign<k>() * anti[a.template edge<k>()];
      out += leaves > 0 ? leaves : 0;
      in -= leaves < 0 ? leaves : 0;
      const Index n = a.template cell<k>();
      low = smaller(low, lowest[n]);
      high = larger(high, highest[n]);
    });
    const double holds = gamma[c] * area[c];
    const double room = (high - settled[c]) * holds, reserve = (settled[c] - low) * holds;
    gain[c] = room >= in ? 1 : room / in;
    loss[c] = reserve >= out ? 1 : reserve / out;
  });
}

void Transport::finish(const Numbers& thickness, Numbers& moved) const {
  const double *low = low_.data(), *anti = anti_.data(), *gain = gain_.data(), *loss = loss_.data();
  const double *h = thickness.data(), *per_area = metric_.per_area.data();
  double* out = moved.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    double sum = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>(), n = a.template cell<k>();
      const double leaves = a.template sign<k>() * anti[e];
      const double leaving = smaller(loss[c], gain[n]), coming = smaller(gain[c], loss[n]);
      sum += a.template sign<k>() * low[e] + leaves * (leaves >= 0 ? leaving : coming);
    });
    out[c] = h[c] - sum * per_area[c];
  });
}

void Transport::move(const Crossing& crossing, const Numbers& before, const Numbers& after, const Numbers& thickness,
                     Numbers& moved) {
  const double *h = thickness.data(), *gamma = before.data();
  double* ratio = ratio_.data();
  const Index cells = metric_.topology().cells;
  for (Index c = 0; c < cells; ++c) ratio[c] = h[c] / gamma[c];
  find_slopes();
  flux_over_edges(crossing);
  find_bounds(after, thickness);
  limit(after);
  finish(thickness, moved);
}

}  // namespace shabon::film
