// The rows of the stack vectors that hold no layer or one.
#include <gtest/gtest.h>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/single_film.h"
#include "vectors.h"

namespace shabon::optics {
namespace {

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

TEST(StackVectors, CoherentSingleFilmsAndInterfaces) {
  constexpr double tolerance = 1e-10;
  const VectorFile file("b_stacks_coherent.csv");
  int interfaces = 0, films = 0;
  for (const VectorRow& row : file.rows) {
    const StackRow at = stack_of(row);
    if (!check_single_film(at.stack, Interference::airy)) continue;
    ++(at.stack.layers.empty() ? interfaces : films);
    expect_powers(row, single_film_powers(at.stack, Interference::airy, at.incidence, at.lambda_nm), tolerance,
                  at.place);
    const auto n1 = at.stack.incidence.index(at.lambda_nm), n3 = at.stack.exit.index(at.lambda_nm);
    const bool bare = at.stack.layers.empty();
    const Amplitudes a = airy_amplitudes(n1, bare ? n3 : at.stack.layers[0].medium.index(at.lambda_nm), n3,
                                         bare ? 0 : at.stack.layers[0].thickness_nm, at.incidence, at.lambda_nm);
    EXPECT_NEAR(a.r_s.real(), row.number("rs_re"), tolerance) << at.place;
    EXPECT_NEAR(a.r_s.imag(), row.number("rs_im"), tolerance) << at.place;
    EXPECT_NEAR(a.r_p.real(), row.number("rp_re"), tolerance) << at.place;
    EXPECT_NEAR(a.r_p.imag(), row.number("rp_im"), tolerance) << at.place;
  }
  EXPECT_EQ(interfaces, 27);
  EXPECT_GE(films, 200);
}

TEST(StackVectors, IncoherentSlabs) {
  constexpr double tolerance = 1e-9;
  const VectorFile file("b_stacks_incoherent.csv");
  int slabs = 0;
  for (const VectorRow& row : file.rows) {
    StackRow at = stack_of(row);
    if (at.stack.layers.size() != 1) continue;
    ++slabs;
    at.stack.layers[0].coherent = false;
    expect_powers(row, single_film_powers(at.stack, Interference::airy, at.incidence, at.lambda_nm), tolerance,
                  at.place);
  }
  EXPECT_EQ(slabs, 15);
}

}  // namespace
}  // namespace shabon::optics
