// Rows of Stokes packets: turning them, and sending them through films.
#include "shabon/optics/packet/stokes_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/base/random.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {
namespace {

constexpr int lanes = 16;
using Row = StokesRow<lanes>;
using P = math::packet<float, lanes>;

Row random_row(Pcg32& random) {
  float q[4][lanes];
  for (auto& component : q)
    for (float& lane : component) lane = static_cast<float>(random.uniform(-1, 1));
  return {P::load(q[0]), P::load(q[1]), P::load(q[2]), P::load(q[3])};
}

Row turned(const Row& row, double phi) {
  return rotated(row, static_cast<float>(std::cos(2 * phi)), static_cast<float>(std::sin(2 * phi)));
}

void expect_rows_near(const Row& a, const Row& b, double tolerance) {
  for (int i = 0; i < lanes; ++i) {
    EXPECT_EQ(a.q0[i], b.q0[i]);
    EXPECT_NEAR(a.q1[i], b.q1[i], tolerance);
    EXPECT_NEAR(a.q2[i], b.q2[i], tolerance);
    EXPECT_EQ(a.q3[i], b.q3[i]);
  }
}

// A light's Stokes numbers by DESIGN: S2 = 2 Re(Es conj Ep), S3 = 2 Im(Es conj Ep).
struct Field {
  std::complex<double> s, p;
};

double measured(const Row& row, int i, const Field& e) {
  const std::complex<double> both = 2.0 * e.s * conj(e.p);
  return row.q0[i] * (norm(e.s) + norm(e.p)) + row.q1[i] * (norm(e.s) - norm(e.p)) + row.q2[i] * both.real() +
         row.q3[i] * both.imag();
}

Field random_field(Pcg32& random) {
  return {{random.uniform(-1, 1), random.uniform(-1, 1)}, {random.uniform(-1, 1), random.uniform(-1, 1)}};
}

TEST(StokesRow, ThereAndBackIsTheIdentity) {
  Pcg32 random(1);
  for (int k = 0; k < 1000; ++k) {
    const Row row = random_row(random);
    const double phi = random.uniform(-4, 4);
    expect_rows_near(turned(turned(row, phi), -phi), row, 5e-7);
  }
}

TEST(StokesRow, ManyTurnsMakeAFullTurn) {
  Pcg32 random(2);
  const Row row = random_row(random);
  expect_rows_near(turned(row, std::numbers::pi), row, 1e-6);  // the frame points backwards: the same frame
  Row there = row;
  for (int k = 0; k < 36; ++k) there = turned(there, std::numbers::pi / 18);
  expect_rows_near(there, row, 5e-6);
}

// What a row measures does not depend on the frame: (15).
TEST(StokesRow, ATurnedRowMeasuresTheSameLight) {
  Pcg32 random(3);
  for (int k = 0; k < 1000; ++k) {
    const Row row = random_row(random);
    const Field e = random_field(random);
    const double phi = random.uniform(-4, 4), c = std::cos(phi), s = std::sin(phi);
    const Field in_new_frame{e.s * c + e.p * s, e.p * c - e.s * s};  // from s towards p
    const Row there = turned(row, phi);
    for (int i = 0; i < lanes; ++i) EXPECT_NEAR(measured(there, i, in_new_frame), measured(row, i, e), 3e-6);
  }
}

// A row before the film measures the light that the film makes of it: (16), by the amplitudes themselves.
TEST(StokesRow, BeforeTheFilmItMeasuresWhatTheFilmMakes) {
  Pcg32 random(4);
  for (int k = 0; k < 1000; ++k) {
    const Row row = random_row(random);
    const Field e = random_field(random), x = random_field(random);  // light, and amplitudes of s and p
    const std::complex<double> both = x.s * conj(x.p);
    const auto filled = [](double value) { return P(static_cast<float>(value)); };
    const MuellerBlock<lanes> block{filled((norm(x.s) + norm(x.p)) / 2), filled((norm(x.s) - norm(x.p)) / 2),
                                    filled(both.real()), filled(both.imag())};
    const Row before = through(row, block);
    const Field after{x.s * e.s, x.p * e.p};
    for (int i = 0; i < lanes; ++i) EXPECT_NEAR(measured(before, i, e), measured(row, i, after), 5e-6);
  }
}

const P zero(0.0f), half(0.5f), one(1.0f);
const MuellerBlock<lanes> polariser{half, half, zero, zero};  // passes s alone

TEST(StokesRow, PolarisersFollowMalus) {
  const Row eye{one, zero, zero, zero};
  for (int degree = 0; degree <= 180; degree += 15) {
    const double phi = degree * std::numbers::pi / 180;
    const Row lamp = through(turned(through(eye, polariser), phi), polariser);
    for (int i = 0; i < lanes; ++i) {
      EXPECT_NEAR(lamp.q0[i], 0.5 * std::pow(std::cos(phi), 2), 2e-7) << degree;
      EXPECT_NEAR(lamp.q1[i], lamp.q0[i], 2e-7) << degree;
      EXPECT_EQ(lamp.q2[i], 0);
    }
  }
}

// Two quarter waves make a half wave: linear light at 45 degrees becomes circular, then linear across.
TEST(StokesRow, QuarterWavesTurnLinearLightCircular) {
  const MuellerBlock<lanes> quarter_wave{one, zero, zero, one};
  const Row diagonal{one, zero, one, zero};
  const Row circular = through(diagonal, quarter_wave);
  const Row across = through(circular, quarter_wave);
  for (int i = 0; i < lanes; ++i) {
    EXPECT_EQ(circular.q2[i], 0);
    EXPECT_EQ(circular.q3[i], -1);
    EXPECT_EQ(across.q2[i], -1);
    EXPECT_EQ(across.q3[i], 0);
  }
}

}  // namespace
}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
