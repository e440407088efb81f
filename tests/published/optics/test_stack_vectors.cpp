// Stacks against independent programs: Byrnes' tmm, checked there against the scattering matrices of PyMoosh.
#include <gtest/gtest.h>

#include <numbers>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/ellipsometry.h"
#include "shabon/optics/reference/stack_model.h"
#include "vectors.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;

struct StackRow {
  Stack stack;
  Incidence incidence;
  double lambda_nm;
  std::string place;
};

StackRow stack_of(const VectorRow& row) {
  const std::vector<double> n = row.list("n_re"), k = row.list("n_im"), d_nm = row.list("d_nm");
  const auto medium = [&](std::size_t i) { return Medium::constant({n.at(i), k.at(i)}); };
  StackRow result{{medium(0), {}, medium(n.size() - 1)},
                  incidence_from(Degrees(row.number("theta_deg"))),
                  row.number("lambda_nm"),
                  row.text("case") + " " + row.text("lambda_nm") + " nm " + row.text("theta_deg") + " deg"};
  for (std::size_t i = 0; i < d_nm.size(); ++i) result.stack.layers.push_back({medium(i + 1), d_nm[i]});
  return result;
}

void expect_powers(const VectorRow& row, const Powers& powers, double tolerance, const std::string& place) {
  EXPECT_NEAR(powers.R_s, row.number("R_s"), tolerance) << place;
  EXPECT_NEAR(powers.R_p, row.number("R_p"), tolerance) << place;
  EXPECT_NEAR(powers.T_s, row.number("T_s"), tolerance) << place;
  EXPECT_NEAR(powers.T_p, row.number("T_p"), tolerance) << place;
}

void expect_amplitudes(const VectorRow& row, const Amplitudes& amplitudes, double tolerance, const std::string& place) {
  EXPECT_LT(std::abs(amplitudes.r_s - Complex(row.number("rs_re"), row.number("rs_im"))), tolerance) << place;
  EXPECT_LT(std::abs(amplitudes.r_p - Complex(row.number("rp_re"), row.number("rp_im"))), tolerance) << place;
  EXPECT_LT(std::abs(amplitudes.t_s - Complex(row.number("ts_re"), row.number("ts_im"))), tolerance) << place;
  EXPECT_LT(std::abs(amplitudes.t_p - Complex(row.number("tp_re"), row.number("tp_im"))), tolerance) << place;
}

void expect_list(const std::vector<double>& found, const std::vector<double>& expected, double tolerance,
                 const std::string& place) {
  ASSERT_EQ(found.size(), expected.size()) << place;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance) << place << " layer " << i;
}

TEST(StackVectors, Coherent) {
  constexpr double tolerance = 1e-10;
  const VectorFile file("b_stacks_coherent.csv");
  for (const VectorRow& row : file.rows) {
    const StackRow at = stack_of(row);
    expect_amplitudes(row, stack_amplitudes(at.stack, at.incidence, at.lambda_nm), tolerance, at.place);
    expect_powers(row, model_powers(at.stack, Interference::airy, at.incidence, at.lambda_nm), tolerance, at.place);
    const StackPowers stack = stack_powers(at.stack, at.incidence, at.lambda_nm);
    expect_powers(row, stack.powers, tolerance, at.place);
    expect_list(stack.A_s, row.list("A_s"), tolerance, at.place);
    expect_list(stack.A_p, row.list("A_p"), tolerance, at.place);
  }
  EXPECT_EQ(file.rows.size(), 309u);
}

// The closed form of one film against the same rows.
TEST(StackVectors, CoherentSingleFilms) {
  int films = 0;
  const VectorFile file("b_stacks_coherent.csv");
  for (const VectorRow& row : file.rows) {
    const StackRow at = stack_of(row);
    if (at.stack.layers.size() != 1) continue;
    ++films;
    const ResolvedStack film = resolve(at.stack, at.lambda_nm);
    const Amplitudes airy =
        airy_amplitudes(film.n1, film.layers[0].n, film.n3, film.layers[0].thickness_nm, at.incidence, at.lambda_nm);
    expect_amplitudes(row, airy, 1e-10, at.place);
  }
  EXPECT_GE(films, 200);
}

TEST(StackVectors, Incoherent) {
  constexpr double tolerance = 1e-9;
  const VectorFile file("b_stacks_incoherent.csv");
  int slabs = 0;
  for (const VectorRow& row : file.rows) {
    StackRow at = stack_of(row);
    for (std::size_t i = 0; i < at.stack.layers.size(); ++i)
      at.stack.layers[i].coherent = row.text("coh").at(i + 1) == 'c';
    const StackPowers stack = stack_powers(at.stack, at.incidence, at.lambda_nm);
    expect_powers(row, stack.powers, tolerance, at.place);
    expect_powers(row, model_powers(at.stack, Interference::airy, at.incidence, at.lambda_nm), tolerance, at.place);
    if (at.stack.layers.size() != 1) continue;
    ++slabs;
    const Powers none = model_powers(at.stack, Interference::none, at.incidence, at.lambda_nm);
    expect_powers(row, none, tolerance, at.place);
  }
  EXPECT_EQ(slabs, 15);
  EXPECT_EQ(file.rows.size(), 32u);
}

// Byrnes' own test, with values of an older program.
TEST(StackVectors, ByrnesBasicTest) {
  constexpr double tolerance = 1e-13;
  const ResolvedStack stack{1, {{{2, 4}, 2}, {{3, 0.3}, 3}}, {1, 0.1}};
  const Incidence incidence{std::cos(0.1), std::sin(0.1)};
  const Amplitudes amplitudes = stack_amplitudes(stack, incidence, 100);
  const Powers powers = stack_powers(stack, incidence, 100).powers;
  const Ellipsometry seen = ellipsometry(amplitudes);
  const VectorFile file("c_stack_byrnes.csv");
  for (const VectorRow& row : file.rows) {
    const bool s = row.text("polarisation") == "s";
    EXPECT_LT(std::abs((s ? amplitudes.r_s : amplitudes.r_p) - Complex(row.number("r_re"), row.number("r_im"))),
              tolerance);
    EXPECT_LT(std::abs((s ? amplitudes.t_s : amplitudes.t_p) - Complex(row.number("t_re"), row.number("t_im"))),
              tolerance);
    EXPECT_NEAR(s ? powers.R_s : powers.R_p, row.number("R"), tolerance);
    EXPECT_NEAR(s ? powers.T_s : powers.T_p, row.number("T"), tolerance);
    constexpr double degrees = 180 / std::numbers::pi;
    EXPECT_NEAR(seen.psi_deg, row.number("psi_rad") * degrees, 1e-11);
    EXPECT_NEAR(180 - seen.delta_deg, row.number("Delta_rad") * degrees, 1e-11);  // its Delta is arg(-r_p/r_s)
  }
  EXPECT_EQ(file.rows.size(), 2u);
}

}  // namespace
}  // namespace shabon::optics
