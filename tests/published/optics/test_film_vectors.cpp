// Single films against independent codes; sources and conventions stand in the headers of the files.
#include <gtest/gtest.h>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/two_beam.h"
#include "vectors.h"

namespace shabon::optics {
namespace {

constexpr double tolerance = 1e-10;

class FreeFilm : public testing::TestWithParam<const char*> {};

TEST_P(FreeFilm, AiryAgrees) {
  const VectorFile file(GetParam());
  ASSERT_GE(file.rows.size(), 300u);
  for (const VectorRow& row : file.rows) {
    const std::complex<double> n(row.number("n"), row.number("k"));
    const Powers film =
        airy(1, n, 1, row.number("d_nm"), incidence_from(Degrees(row.number("theta_deg"))), row.number("lambda_nm"));
    const std::string place = row.text("n") + " " + row.text("d_nm") + " nm " + row.text("theta_deg") + " deg";
    EXPECT_NEAR(film.R_s, row.number("R_s"), tolerance) << place;
    EXPECT_NEAR(film.R_p, row.number("R_p"), tolerance) << place;
    EXPECT_NEAR(film.T_s, row.number("T_s"), tolerance) << place;
    EXPECT_NEAR(film.T_p, row.number("T_p"), tolerance) << place;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, FreeFilm, testing::Values("a_film_grid.csv", "a_film_random.csv"),
                         [](const auto& file) { return std::string(file.index == 0 ? "grid" : "random"); });

TEST(TwoBeamVectors, TwoBeamAndAiryAgree) {
  const VectorFile file("e_twobeam.csv");
  ASSERT_GE(file.rows.size(), 300u);
  for (const VectorRow& row : file.rows) {
    const double n = row.number("n"), d_nm = row.number("d_nm"), lambda_nm = row.number("lambda_nm");
    const Incidence incidence = incidence_from(Degrees(row.number("theta_deg")));
    const std::string place = row.text("n") + " " + row.text("d_nm") + " nm " + row.text("theta_deg") + " deg";
    const Powers beams = two_beam(1, n, 1, d_nm, incidence, lambda_nm);
    EXPECT_NEAR(beams.R_s, row.number("R2_s"), tolerance) << place;
    EXPECT_NEAR(beams.R_p, row.number("R2_p"), tolerance) << place;
    EXPECT_NEAR(beams.T_s, row.number("T2_s"), tolerance) << place;
    EXPECT_NEAR(beams.T_p, row.number("T2_p"), tolerance) << place;
    const Powers exact = airy(1, n, 1, d_nm, incidence, lambda_nm);
    EXPECT_NEAR(exact.R_s, row.number("R_exact_s"), tolerance) << place;
    EXPECT_NEAR(exact.R_p, row.number("R_exact_p"), tolerance) << place;
  }
}

}  // namespace
}  // namespace shabon::optics
