#include "oracle_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::oracle {

namespace {

constexpr Complex i{0, 1};

struct Angles {
  double c1;
  Complex c2;
};

Angles angles(double n_outside, Complex n_film, double cos_i) {
  const double sin_i = std::sqrt((1 - cos_i) * (1 + cos_i));
  const Complex s2 = n_outside * sin_i / n_film;
  Complex c2 = std::sqrt(1.0 - s2 * s2);
  if ((n_film * c2).imag() < 0) c2 = -c2;
  return {cos_i, c2};
}

struct FieldRatios {
  Complex r, t;
};

// From the tangential fields on both faces: (E, H) in front = M (1, y1) behind, with the admittances y = n c for s and
// n/c for p.
FieldRatios by_characteristic_matrix(Complex y1, Complex y2, Complex delta) {
  const Complex m11 = std::cos(delta), m12 = -i * std::sin(delta) / y2, m21 = -i * y2 * std::sin(delta);
  const Complex e = m11 + m12 * y1, h = m21 + m11 * y1;
  return {(y1 * e - h) / (y1 * e + h), 2.0 * y1 / (y1 * e + h)};
}

FilmResponse exact(double n1, Complex n2, double thickness_nm, Angles at, double wavelength_nm) {
  const Complex delta = 2 * std::numbers::pi * n2 * at.c2 * thickness_nm / wavelength_nm;
  const FieldRatios s = by_characteristic_matrix(n1 * at.c1, n2 * at.c2, delta);
  FieldRatios p = by_characteristic_matrix(n1 / at.c1, n2 / at.c2, delta);
  p.r = -p.r;  // along p = k x s, whose tangential part turns round on reflection
  return {{std::norm(s.r), std::norm(p.r), s.r * std::conj(p.r)},
          {std::norm(s.t), std::norm(p.t), s.t * std::conj(p.t)}};
}

struct Wall {
  Complex r_s, r_p, t_s, t_p;
};

Wall wall(Complex n1, Complex c1, Complex n2, Complex c2) {
  return {(n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2), (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2),
          2.0 * n1 * c1 / (n1 * c1 + n2 * c2), 2.0 * n1 * c1 / (n2 * c1 + n1 * c2)};
}

// One ray after another, each with the coherency of its own s and p.
FilmResponse without_phase(double n1, Complex n2, double thickness_nm, Angles at, double wavelength_nm) {
  const Wall in = wall(n1, at.c1, n2, at.c2), out = wall(n2, at.c2, n1, at.c1);
  const double once = std::exp(-2 * std::numbers::pi * (n2 * at.c2).imag() * thickness_nm / wavelength_nm);
  FilmResponse sum;
  const auto add = [](CoherencyFactors& to, Complex s, Complex p) {
    to.ss += std::norm(s), to.pp += std::norm(p), to.sp += s * std::conj(p);
  };
  add(sum.reflected, in.r_s, in.r_p);
  Complex s = in.t_s * once, p = in.t_p * once;  // at the far wall
  while (std::max(std::norm(s), std::norm(p)) > 1e-18) {
    add(sum.transmitted, s * out.t_s, p * out.t_p);
    s *= out.r_s * once, p *= out.r_p * once;  // back at the near wall
    add(sum.reflected, s * out.t_s, p * out.t_p);
    s *= out.r_s * once, p *= out.r_p * once;
  }
  return sum;
}

// The paper: two rays of amplitudes q and b at the phase difference alpha; means over s and p at each wall.
FilmResponse paper(double n1, Complex n2, double thickness_nm, Angles at, double wavelength_nm) {
  const Wall in = wall(n1, at.c1, n2, at.c2);
  const double alpha =
      4 * std::numbers::pi * n2.real() * at.c2.real() * thickness_nm / wavelength_nm - std::numbers::pi;
  const auto reflected = [&](double q) {
    const double b = q * (1 - q * q);
    return std::min(1.0, q * q + b * b + 2 * q * b * std::cos(alpha));
  };
  const auto passed = [](double q) { return (1 - q * q) * (1 - q * q); };
  const double q_s = std::abs(in.r_s), q_p = std::abs(in.r_p);
  const double h = (reflected(q_s) + reflected(q_p)) / 2, t = (passed(q_s) + passed(q_p)) / 2;
  return {{h, h, 0}, {t, t, 0}, true};
}

}  // namespace

FilmResponse stack_response(double n_outside, const std::vector<Layer>& layers, double cos_i, double wavelength_nm) {
  std::vector<Complex> n{n_outside}, c{cos_i};
  for (const Layer& layer : layers) n.push_back(layer.n), c.push_back(angles(n_outside, layer.n, cos_i).c2);
  n.push_back(n_outside), c.push_back(cos_i);
  Wall all = wall(n[layers.size()], c[layers.size()], n_outside, cos_i);
  for (std::size_t j = layers.size(); j-- > 0;) {
    const Wall front = wall(n[j], c[j], n[j + 1], c[j + 1]);
    const Complex once =
        std::exp(2 * std::numbers::pi * i * n[j + 1] * c[j + 1] * layers[j].thickness_nm / wavelength_nm);
    const auto joined = [&](Complex r_front, Complex t_front, Complex& r, Complex& t) {
      const Complex bounces = 1.0 + r_front * r * once * once;
      t = t_front * t * once / bounces;
      r = (r_front + r * once * once) / bounces;
    };
    joined(front.r_s, front.t_s, all.r_s, all.t_s);
    joined(front.r_p, front.t_p, all.r_p, all.t_p);
  }
  return {{std::norm(all.r_s), std::norm(all.r_p), all.r_s * std::conj(all.r_p)},
          {std::norm(all.t_s), std::norm(all.t_p), all.t_s * std::conj(all.t_p)}};
}

FilmResponse film_response(optics::Interference model, double n_outside, Complex n_film, double thickness_nm,
                           double cos_i, double wavelength_nm) {
  const Angles at = angles(n_outside, n_film, cos_i);
  if (model == optics::Interference::two_beam) return paper(n_outside, n_film, thickness_nm, at, wavelength_nm);
  if (model == optics::Interference::none) return without_phase(n_outside, n_film, thickness_nm, at, wavelength_nm);
  return exact(n_outside, n_film, thickness_nm, at, wavelength_nm);
}

}  // namespace shabon::oracle
