#include "shabon/desk/kernel/sweep_table.h"

#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/layer_fields.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::desk {

namespace {

using Complex = std::complex<double>;

// Where the swept layer's n c is this much smaller than n of the first medium, its two waves are nearly one: they are
// then computed as sine and cosine, by the reference.
constexpr double least_normal_index = 1e-3;

// What gives the light before the stack from the fields at a face inside, here F1 and G1: F F1 + G G1.
struct FrontRow {
  Complex F, G;
};

// (31) from the other end: what stands before the layer's near face becomes what stands before its far face.
FrontRow crossed(const FrontRow& row, const optics::Crossing& layer) {
  constexpr Complex i(0, 1);
  return {layer.cos_beta * row.F - i * layer.u_sin_beta * row.G,
          layer.cos_beta * row.G - i * layer.sin_beta_over_u * row.F};
}

// One polarisation of the cut stack at one wavelength.
struct Cut {
  Complex u1;
  FrontRow incident, reflected;    // at the swept layer's near face
  optics::TangentialFields below;  // at its far face
  double factor = 1;               // of all scalings
  Complex u;                       // of the swept layer

  Cut(Complex first, Complex last) : u1(first), incident{first, 1}, reflected{first, -1}, below{1, last} {}

  void cross_above(const optics::Crossing& layer) {
    incident = crossed(incident, layer), reflected = crossed(reflected, layer);
    const double size = norm(incident.F) + norm(incident.G) + norm(reflected.F) + norm(reflected.G);
    const double scale = std::ldexp(1.0, -std::ilogb(size) / 2);  // exact
    for (Complex* value : {&incident.F, &incident.G, &reflected.F, &reflected.G}) *value *= scale;
    factor *= layer.decay * scale;
  }
  void cross_below(const optics::Crossing& layer) { factor *= optics::cross(below, layer); }
};

// The four numbers of (46).
struct Square {
  double gap, far, cosine, sine;
  double size() const { return std::abs(gap) + 2 * far; }  // |X0| + |X1|, but for the sign of gap
};

// (45) to (47). gap = |X0| - |X1| is formed from what flows through the layer: by subtraction it would lose its digits
// at grazing incidence, where both parts of the stack reflect nearly everything.
Square square_of(const FrontRow& row, Complex u, const optics::TangentialFields& below) {
  const Complex Gu = row.G * u, G_u = below.G / u;
  const Complex row_sum = row.F + Gu, row_difference = row.F - Gu;
  const Complex below_sum = below.F + G_u, below_difference = below.F - G_u;
  const Complex x0 = row_sum * below_sum, x1 = row_difference * below_difference;
  const double size = abs(x0) + abs(x1);
  if (size == 0) return {0, 0, 0, 0};
  const double flow = 4 * (norm(row_sum) * real(below.F * conj(G_u)) + norm(below_difference) * real(row.F * conj(Gu)));
  const Complex root = std::sqrt(conj(x0) * x1);
  return {flow / size, abs(x1), 2 * root.real(), -2 * root.imag()};
}

void store(SquareRows& rows, std::size_t i, const Square& square, double scale) {
  rows.gap[i] = square.gap * scale;
  rows.far[i] = square.far * scale;
  rows.cosine[i] = square.cosine * scale;
  rows.sine[i] = square.sine * scale;
}

void store(PolarisationRows& rows, std::size_t i, const Cut& cut, double passed) {
  const Square incident = square_of(cut.incident, cut.u, cut.below);
  const double scale = 1 / incident.size();
  store(rows.incident, i, incident, scale);
  store(rows.reflected, i, square_of(cut.reflected, cut.u, cut.below), scale);
  rows.passed[i] = passed * scale * scale;
}

void resize(PolarisationRows& rows, std::size_t size) {
  for (SquareRows* square : {&rows.incident, &rows.reflected})
    for (std::vector<double>* row : {&square->gap, &square->far, &square->cosine, &square->sine}) row->assign(size, 0);
  rows.incident.gap.assign(size, 1);  // nothing is divided by 0
  rows.passed.assign(size, 0);
}

class Builder {
 public:
  Builder(SweepTable& table, std::size_t layer, optics::Incidence incidence)
      : table_(table), layer_(layer), incidence_(incidence) {}

  void add(std::size_t i, const optics::ResolvedStack& stack, double wavelength_nm) {
    Complex n_c = optics::normal_index(stack.n1, incidence_, stack.layers[layer_].n);
    if (n_c.imag() < 0) n_c = -n_c;  // as in plane_layer()
    if (abs(n_c) < least_normal_index * abs(stack.n1)) return table_.near_critical.push_back(i);
    table_.half_turns_per_nm[i] = 2 * n_c.real() / wavelength_nm;
    table_.halvings_per_nm[i] = 4 * std::numbers::pi * std::numbers::log2e * n_c.imag() / wavelength_nm;
    table_.lossless = table_.lossless && n_c.imag() == 0;
    add_fields(i, stack, n_c, wavelength_nm);
  }

 private:
  void add_fields(std::size_t i, const optics::ResolvedStack& stack, Complex n_c, double wavelength_nm) {
    const optics::FieldRatios u1 = optics::field_ratios(stack.n1, stack.n1 * incidence_.cos_i);
    const optics::FieldRatios u3 = optics::field_ratios(stack.n3, optics::normal_index(stack.n1, incidence_, stack.n3));
    Cut s(u1.s, u3.s), p(u1.p, u3.p);
    const auto at = [&](std::size_t j) {
      return optics::plane_layer(stack.n1, incidence_, stack.layers[j].n, stack.layers[j].thickness_nm, wavelength_nm);
    };
    for (std::size_t j = 0; j < layer_; ++j) {
      const optics::PlaneLayer layer = at(j);
      s.cross_above(crossing_s(layer)), p.cross_above(crossing_p(layer));
    }
    for (std::size_t j = stack.layers.size(); --j > layer_;) {
      const optics::PlaneLayer layer = at(j);
      s.cross_below(crossing_s(layer)), p.cross_below(crossing_p(layer));
    }
    const optics::FieldRatios u = optics::field_ratios(stack.layers[layer_].n, n_c);
    s.u = u.s, p.u = u.p;
    // |t|^2 = |4 u1 factor|^2 kept/|X0 + X1 w|^2, and (9).
    const optics::Powers passed = optics::powers_of(
        {0, 0, 4.0 * s.u1 * s.factor, stack.n1 / stack.n3 * (4.0 * p.u1 * p.factor)}, stack.n1, stack.n3, incidence_);
    store(table_.s, i, s, passed.T_s);
    store(table_.p, i, p, passed.T_p);
  }

  SweepTable& table_;
  std::size_t layer_;
  optics::Incidence incidence_;
};

}  // namespace

SweepTable sweep_table(const optics::Stack& stack, std::size_t layer, optics::Incidence incidence,
                       std::span<const double> wavelengths_nm) {
  SweepTable table;
  table.wavelengths = wavelengths_nm.size();
  table.padded = (table.wavelengths + sweep_row_multiple - 1) / sweep_row_multiple * sweep_row_multiple;
  table.half_turns_per_nm.assign(table.padded, 0);
  table.halvings_per_nm.assign(table.padded, 0);
  table.normal_incidence = incidence.sin_i == 0;
  resize(table.s, table.padded);
  resize(table.p, table.padded);
  Builder builder(table, layer, incidence);
  optics::ResolvedStack resolved;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    optics::resolve(stack, wavelengths_nm[i], resolved);
    builder.add(i, resolved, wavelengths_nm[i]);
  }
  return table;
}

}  // namespace shabon::desk
