// Motions whose rates are known: viscous decay, elastic waves, Rossby-Haurwitz waves.
#include <numbers>

#include "laboratory.h"

namespace shabon::film {
namespace {

using math::Vec3d;
using std::numbers::pi;
using test::Laboratory;
using test::legendre;

// The rate of decay per second of a slow zonal flow with the stream function P_l.
double decay_rate(int l, double viscosity_m2_s) {
  FlowDesc desc = test::quiet_film();
  desc.viscosity_pa_s = viscosity_m2_s * desc.density_kg_m3;
  desc.elasticity_n_m = 0.5;
  Laboratory lab(desc);
  const Vec3d axis = math::normalize(Vec3d{0.2, 0.7, -0.5});
  lab.set_stream([&](const Vec3d& at) { return 1e-4 * legendre(l, math::dot(axis, at)); });
  const Numbers start = lab.film.along;
  lab.run_to(2);
  return -std::log(lab.overlap(lab.film.along, start) / lab.overlap(start, start)) / 2;
}

TEST(Viscosity, DampsEachHarmonicAtItsRate) {
  constexpr double nu = 2e-5;
  for (const int l : {2, 3, 5}) {
    const double exact = nu * (l * (l + 1) - 2) / (0.05 * 0.05), rate = decay_rate(l, nu);
    std::printf("l = %d: %.6f per s, relative error %.1e\n", l, rate, rate / exact - 1);
    EXPECT_NEAR(rate / exact, 1, 0.005) << l;
  }
}

TEST(Viscosity, LeavesARotationAlone) {
  const double rate = decay_rate(1, 2e-5);
  std::printf("l = 1: %.1e per s\n", rate);
  EXPECT_LT(std::abs(rate), 1e-4);
}

// When a swelling of the second harmonic is gone for the first time.
double first_zero_s(double drag) {
  FlowDesc desc = test::quiet_film();
  desc.air_drag_kg_m2_s = drag;
  desc.step.longest_s = 4e-5;
  desc.step.tolerance = 1e-11;
  Laboratory lab(desc);
  const Vec3d axis = math::normalize(Vec3d{0.2, 0.7, -0.5});
  const auto harmonic = [&](const Vec3d& at) { return legendre(2, math::dot(axis, at)); };
  for (std::size_t c = 0; c < lab.film.surfactant.size(); ++c) {
    const double here = 1 + 1e-4 * harmonic(lab.metric.grid->centres[c]);
    lab.film.surfactant[c] = lab.film.surfactant_last[c] = here;
    lab.film.thickness[c] *= here;
  }
  double before = lab.project(lab.film.surfactant, harmonic), now = before;
  while (now > 0 && lab.film.time_s < 0.1) {
    before = now;
    lab.run_to(lab.film.time_s + desc.step.longest_s);
    now = lab.project(lab.film.surfactant, harmonic);
  }
  return lab.film.time_s - desc.step.longest_s * now / (now - before);
}

TEST(ElasticWave, PassesZeroWhenItShould) {
  for (const double drag : {0.0, 0.04}) {
    const double c2 = 22e-3 / 1e-3, b = drag / 2e-3, w = std::sqrt(c2 * 6 / 0.0025 - b * b);
    const double exact = (pi / 2 + std::atan(b / w)) / w, zero = first_zero_s(drag);
    std::printf("drag %.2f: zero at %.6f s, relative error %.1e\n", drag, zero, zero / exact - 1);
    EXPECT_NEAR(zero / exact, 1, 0.003);
  }
}

// A wave of degree 5 and order 4 on a rotation is carried along at 28/30 of its rate.
TEST(RossbyHaurwitzWave, TurnsAtItsRate) {
  FlowDesc desc = test::quiet_film();
  desc.elasticity_n_m = 0.5;
  Laboratory lab(desc);
  constexpr double spin = 6;  // 1/s
  const double scale = desc.radius_m * desc.radius_m * spin;
  const Vec3d z = math::normalize(Vec3d{0.2, 0.7, -0.5}), x = math::normalize(math::cross(z, Vec3d{1, 0, 0}));
  const Vec3d y = math::cross(z, x);
  // Y_5^4 is sin(theta)^4 cos(theta) times cosine and sine of four times the longitude.
  const auto wave = [&](const Vec3d& at, bool sine) {
    const double a = math::dot(at, x), b = math::dot(at, y), real = a * a - b * b, imaginary = 2 * a * b;
    return math::dot(at, z) * (sine ? 2 * real * imaginary : real * real - imaginary * imaginary);
  };
  Numbers cosine, sine;
  lab.set_stream([&](const Vec3d& at) { return wave(at, true); });
  sine = lab.film.along;
  lab.set_stream([&](const Vec3d& at) { return wave(at, false); });
  cosine = lab.film.along;
  lab.set_stream([&](const Vec3d& at) { return scale * (-math::dot(at, z) + 0.2 * wave(at, false)); });
  const double energy = lab.overlap(lab.film.along, lab.film.along), at_start = lab.overlap(lab.film.along, cosine);
  lab.run_to(2 * pi / spin);
  const double in_phase = lab.overlap(lab.film.along, cosine), behind = lab.overlap(lab.film.along, sine);
  const double expected = 4 * 28.0 / 30 * 2 * pi;
  const double off = std::remainder(std::atan2(behind, in_phase) - expected, 2 * pi);
  const double amplitude = std::hypot(in_phase, behind) / at_start;
  const double kept = lab.overlap(lab.film.along, lab.film.along) / energy;
  std::printf("level %d: rate off by %.2f %%, amplitude %.3f, kinetic energy %.4f\n", test::level, 100 * off / expected,
              amplitude, kept);
  EXPECT_NEAR(off / expected, 0, 0.01);
  EXPECT_NEAR(amplitude, 1, 0.02);
  EXPECT_NEAR(kept, 1, 0.01);
}

}  // namespace
}  // namespace shabon::film
