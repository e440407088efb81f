#include "shabon/desk/thickness_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::desk {

namespace {

constexpr std::array<QuantityEntry, 6> quantity_list = {{
    {Quantity::R, "R", "reflected share of unpolarised light"},
    {Quantity::R_s, "R_s", "reflected share, s"},
    {Quantity::R_p, "R_p", "reflected share, p"},
    {Quantity::T, "T", "transmitted share of unpolarised light"},
    {Quantity::T_s, "T_s", "transmitted share, s"},
    {Quantity::T_p, "T_p", "transmitted share, p"},
}};

double value_of(Quantity quantity, const optics::Powers& powers) {
  switch (quantity) {
    case Quantity::R:
      return unpolarised(powers, desk::Side::reflected);
    case Quantity::R_s:
      return powers.R_s;
    case Quantity::R_p:
      return powers.R_p;
    case Quantity::T:
      return unpolarised(powers, desk::Side::transmitted);
    case Quantity::T_s:
      return powers.T_s;
    case Quantity::T_p:
      return powers.T_p;
  }
  return 0;
}

// Fields outside of this range are scaled back to about 1.
constexpr double largest_size = 0x1p300;

// Power of two that brings a squared size back to about 1; mostly 1.
double scale_for(double size) {
  if ((size > 1 / largest_size && size < largest_size) || size == 0) return 1;
  return std::ldexp(1.0, -std::ilogb(size) / 2);
}

// film_terms() of a layer without absorption, in real numbers: most of a search's time goes into them.
constexpr double least_clear_index = 1e-3;  // of n cos, far from the critical angle
optics::FilmTerms clear_terms(double n_c, double thickness_nm, double wavelength_nm) {
  const double beta = 2 * std::numbers::pi * n_c * thickness_nm / wavelength_nm;
  const double sine = std::sin(beta);
  return {std::cos(beta), sine, sine / n_c, 1};
}

}  // namespace

std::span<const QuantityEntry> quantities() { return quantity_list; }

bool has_fringes(const UnknownFilm& film, std::size_t unknown) {
  return film.stack.layers[film.unknowns[unknown].layers.front()].coherent;
}

double fringes_per_nm(const UnknownFilm& film, std::size_t unknown, std::span<const ModelRow> rows) {
  const optics::Layer& layer = film.stack.layers[film.unknowns[unknown].layers.front()];
  double most = 0;
  for (const ModelRow& row : rows) {
    const std::complex<double> n1 = film.stack.incidence.index(row.wavelength_nm);
    const std::complex<double> n_c = optics::normal_index(n1, row.incidence, layer.medium.index(row.wavelength_nm));
    most = std::max(most, 2 * (layer.coherent ? std::abs(n_c) : std::abs(n_c.imag())) / row.wavelength_nm);
  }
  return most;
}

// R and T of one polarisation, and their slopes for each unknown.
struct FilmModel::Shares {
  double R = 0, T = 0;
  std::array<double, most_unknowns> R_slopes{}, T_slopes{};
};

FilmModel::FilmModel(const UnknownFilm& film, std::span<const ModelRow> rows, std::span<const Quantity> quantities)
    : film_(film), quantities_(quantities.begin(), quantities.end()) {
  using enum Quantity;
  for (const Quantity quantity : quantities_) {
    needs_s_ = needs_s_ || (quantity != R_p && quantity != T_p);
    needs_p_ = needs_p_ || (quantity != R_s && quantity != T_s);
  }
  for (const Unknown& unknown : film_.unknowns)
    for (const std::size_t layer : unknown.layers) film_.stack.layers[layer].thickness_nm = 0;
  one_by_one_ = !std::all_of(film_.stack.layers.begin(), film_.stack.layers.end(), [](const optics::Layer& layer) {
    return layer.coherent;
  }) || std::any_of(rows.begin(), rows.end(), [&](const ModelRow& row) {
    return row.incidence.cos_i == 0 || film_.stack.incidence.index(row.wavelength_nm).imag() != 0;
  });
  prepare_steps();
  for (const ModelRow& row : rows) rows_.push_back(one_by_one_ ? Row{row, {}, {}, {}} : prepared(row));
  for (std::size_t i = 0; i < film_.unknowns.size(); ++i) set_thickness(i, 0);
}

void FilmModel::prepare_steps() {
  std::vector<std::size_t> unknown_of(film_.stack.layers.size(), most_unknowns);
  for (std::size_t i = 0; i < film_.unknowns.size(); ++i)
    for (const std::size_t layer : film_.unknowns[i].layers) unknown_of[layer] = i;
  std::size_t blocks = 0;
  for (std::size_t layer = film_.stack.layers.size(); layer-- > 0;) {
    const bool is_known = unknown_of[layer] == most_unknowns;
    if (!is_known)
      steps_.push_back({false, unknown_of[layer]});
    else if (steps_.empty() || !steps_.back().is_known)
      steps_.push_back({true, blocks++});
  }
}

FilmModel::Row FilmModel::prepared(const ModelRow& at) const {
  Row row{at, {}, {}, {}};
  const optics::ResolvedStack stack = optics::resolve(film_.stack, at.wavelength_nm);
  const auto ratios = [&](Complex n) {
    return optics::field_ratios(n, optics::normal_index(stack.n1, at.incidence, n));
  };
  const optics::FieldRatios u1 = optics::field_ratios(stack.n1, stack.n1 * at.incidence.cos_i), u3 = ratios(stack.n3);
  row.s.u1 = u1.s, row.p.u1 = u1.p, row.s.u3 = u3.s, row.p.u3 = u3.p;

  std::vector<bool> is_known(stack.layers.size(), true);
  for (const Unknown& unknown : film_.unknowns) {
    const Complex n = stack.layers[unknown.layers.front()].n;
    Complex n_c = optics::normal_index(stack.n1, at.incidence, n);
    if (n_c.imag() < 0) n_c = -n_c;
    row.unknowns.push_back({n_c, optics::field_ratios(n, n_c), n * n, {}});
    for (const std::size_t layer : unknown.layers) is_known[layer] = false;
  }
  const auto add = [](Side& side, const optics::Crossing& layer, bool is_new) {
    constexpr Complex i(0, 1);
    if (is_new) side.known.emplace_back();
    Matrix& m = side.known.back();
    const Matrix far = m;
    const Complex fg = -i * layer.sin_beta_over_u, gf = -i * layer.u_sin_beta;
    m = {layer.cos_beta * far.ff + fg * far.gf, layer.cos_beta * far.fg + fg * far.gg,
         layer.cos_beta * far.gf + gf * far.ff, layer.cos_beta * far.gg + gf * far.fg};
    const double scale = scale_for(norm(m.ff) + norm(m.fg) + norm(m.gf) + norm(m.gg));
    if (scale != 1) m = {m.ff * scale, m.fg * scale, m.gf * scale, m.gg * scale};
    side.decay *= layer.decay * scale;
  };
  bool is_new = true;
  for (std::size_t j = stack.layers.size(); j-- > 0; is_new = !is_known[j]) {
    if (!is_known[j]) continue;
    const optics::PlaneLayer layer =
        optics::plane_layer(stack.n1, at.incidence, stack.layers[j].n, stack.layers[j].thickness_nm, at.wavelength_nm);
    add(row.s, crossing_s(layer), is_new), add(row.p, crossing_p(layer), is_new);
  }
  return row;
}

void FilmModel::set_thickness(std::size_t unknown, double thickness_nm) {
  for (const std::size_t layer : film_.unknowns[unknown].layers) film_.stack.layers[layer].thickness_nm = thickness_nm;
  if (one_by_one_) return;
  for (Row& row : rows_) {
    Crossed& crossed = row.unknowns[unknown];
    crossed.terms = crossed.n_c.imag() == 0 && crossed.n_c.real() > least_clear_index
                        ? clear_terms(crossed.n_c.real(), thickness_nm, row.at.wavelength_nm)
                        : optics::film_terms(crossed.n_c, thickness_nm, row.at.wavelength_nm);
  }
}

// (31) and (33) of one polarisation, and with slopes (49).
template <bool WithSlopes>
FilmModel::Shares FilmModel::side_shares(const Row& row, bool is_p) const {
  constexpr Complex i(0, 1);
  const Side& side = is_p ? row.p : row.s;
  const std::size_t count = WithSlopes ? film_.unknowns.size() : 0;
  struct Fields {
    Complex F, G;
  };
  Fields at{1, side.u3};
  std::array<Fields, most_unknowns> slopes{};
  double decay = side.decay;
  const auto apply = [](const Matrix& m, const Fields& far) {
    return Fields{m.ff * far.F + m.fg * far.G, m.gf * far.F + m.gg * far.G};
  };
  for (const Step& step : steps_) {
    Matrix m;
    if (step.is_known) {
      m = side.known[step.index];
    } else {
      const Crossed& layer = row.unknowns[step.index];
      const optics::FilmTerms& terms = layer.terms;
      const Complex sin_over_u = is_p ? layer.n_squared * terms.sin_beta_over_n_c : terms.sin_beta_over_n_c;
      const Complex u_sin = (is_p ? layer.u.p : layer.u.s) * terms.sin_beta;
      m = {terms.cos_beta, -i * sin_over_u, -i * u_sin, terms.cos_beta};
      decay *= terms.decay;
    }
    const Fields far = at;
    at = apply(m, far);
    for (std::size_t k = 0; k < count; ++k) slopes[k] = apply(m, slopes[k]);
    if (WithSlopes && !step.is_known) {
      const Crossed& layer = row.unknowns[step.index];
      const Complex per_nm = 2 * std::numbers::pi / row.at.wavelength_nm;
      const Complex over_u = is_p ? layer.n_squared : Complex(1), u = is_p ? layer.u.p : layer.u.s;
      const Complex turn = -per_nm * layer.n_c * layer.terms.sin_beta;
      const Fields slope = apply(
          {turn, -i * per_nm * over_u * layer.terms.cos_beta, -i * per_nm * u * layer.n_c * layer.terms.cos_beta, turn},
          far);
      slopes[step.index].F += slope.F, slopes[step.index].G += slope.G;
    }
    const double scale = scale_for(norm(at.F) + norm(at.G));
    if (scale == 1) continue;
    at.F *= scale, at.G *= scale, decay *= scale;
    for (std::size_t k = 0; k < count; ++k) slopes[k].F *= scale, slopes[k].G *= scale;
  }

  const Complex sum = side.u1 * at.F + at.G, difference = side.u1 * at.F - at.G;
  const double over = 1 / norm(sum);
  Shares shares;
  shares.R = norm(difference) * over;
  shares.T = 4 * side.u1.real() * side.u3.real() * decay * decay * over;
  for (std::size_t k = 0; k < count; ++k) {
    const Complex sum_slope = side.u1 * slopes[k].F + slopes[k].G;
    const Complex difference_slope = side.u1 * slopes[k].F - slopes[k].G;
    const double growth = 2 * real(conj(sum) * sum_slope) * over;
    shares.R_slopes[k] = 2 * real(conj(difference) * difference_slope) * over - shares.R * growth;
    shares.T_slopes[k] = -shares.T * growth;
  }
  return shares;
}

template <bool WithSlopes>
void FilmModel::evaluate(std::span<double> shares, std::span<double> slopes) const {
  std::size_t at = 0;
  for (const Row& row : rows_) {
    const bool alike = row.at.incidence.sin_i == 0;
    Shares s, p;
    if (needs_s_ || alike) s = side_shares<WithSlopes>(row, false);
    if (alike)
      p = s;
    else if (needs_p_)
      p = side_shares<WithSlopes>(row, true);
    for (const Quantity quantity : quantities_) {
      shares[at] = value_of(quantity, {s.R, p.R, s.T, p.T});
      if (WithSlopes)
        for (std::size_t k = 0; k < film_.unknowns.size(); ++k)
          slopes[k * size() + at] = value_of(quantity, {s.R_slopes[k], p.R_slopes[k], s.T_slopes[k], p.T_slopes[k]});
      ++at;
    }
  }
}

void FilmModel::evaluate_one_by_one(std::span<double> shares) const {
  std::size_t at = 0;
  for (const Row& row : rows_) {
    const optics::Powers powers =
        film_powers(film_.stack, optics::Interference::airy, row.at.incidence, row.at.wavelength_nm);
    for (const Quantity quantity : quantities_) shares[at++] = value_of(quantity, powers);
  }
}

// Central differences; forward ones at zero thickness.
void FilmModel::slopes_one_by_one(std::span<double> slopes) {
  double shortest_nm = std::numeric_limits<double>::max();
  for (const Row& row : rows_) shortest_nm = std::min(shortest_nm, row.at.wavelength_nm);
  const double step_nm = 1e-5 * shortest_nm;  // the cube root of a double's rounding
  std::vector<double> low(size()), high(size());
  for (std::size_t k = 0; k < film_.unknowns.size(); ++k) {
    const double at_nm = film_.stack.layers[film_.unknowns[k].layers.front()].thickness_nm;
    const double low_nm = std::max(0.0, at_nm - step_nm), high_nm = low_nm + 2 * step_nm;
    set_thickness(k, low_nm), evaluate_one_by_one(low);
    set_thickness(k, high_nm), evaluate_one_by_one(high);
    set_thickness(k, at_nm);
    for (std::size_t i = 0; i < size(); ++i) slopes[k * size() + i] = (high[i] - low[i]) / (high_nm - low_nm);
  }
}

void FilmModel::shares(std::span<double> shares) {
  one_by_one_ ? evaluate_one_by_one(shares) : evaluate<false>(shares, {});
}

void FilmModel::shares_and_slopes(std::span<double> shares, std::span<double> slopes) {
  if (!one_by_one_) return evaluate<true>(shares, slopes);
  evaluate_one_by_one(shares);
  slopes_one_by_one(slopes);
}

}  // namespace shabon::desk
