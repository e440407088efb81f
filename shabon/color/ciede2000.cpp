#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/color/lab.h"

// Names and steps follow the paper named in lab.h; its equation numbers stand in the comments.
namespace shabon::color {

namespace {

constexpr double degree = std::numbers::pi / 180;

double seventh_power_share(double chroma) {  // sqrt(C^7 / (C^7 + 25^7))
  constexpr double pow_25_7 = 6103515625.0;
  const double pow_c_7 = std::pow(chroma, 7);
  return std::sqrt(pow_c_7 / (pow_c_7 + pow_25_7));
}

double hue_deg(double a, double b) {  // (7): 0..360, and 0 for a grey
  if (a == 0 && b == 0) return 0;
  const double hue = std::atan2(b, a) / degree;
  return hue < 0 ? hue + 360 : hue;
}

struct Hues {
  double difference_deg, mean_deg;
};

// (10) and (14). Opposite hues stand on a branch of both: they take the side of a difference of exactly 180 degrees,
// also when rounding in atan2 has pushed them across it (pair 14 of the published ones).
Hues compare_hues(double h1, double h2, bool either_grey) {
  constexpr double opposite_deg = 180 + 1e-9;
  if (either_grey) return {0, h1 + h2};
  const double difference = h2 - h1, sum = h1 + h2;
  if (std::abs(difference) <= opposite_deg) return {difference, sum / 2};
  return {difference > 0 ? difference - 360 : difference + 360, sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2};
}

}  // namespace

double ciede2000(Lab first, Lab second) {
  const double mean_c = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;  // (2), (3)
  const double g = 0.5 * (1 - seventh_power_share(mean_c));                                   // (4)
  const double a1 = (1 + g) * first.a, a2 = (1 + g) * second.a;                               // (5)
  const double c1 = std::hypot(a1, first.b), c2 = std::hypot(a2, second.b);                   // (6)
  const Hues hues = compare_hues(hue_deg(a1, first.b), hue_deg(a2, second.b), c1 * c2 == 0);

  const double delta_l = second.L - first.L;                                                   // (8)
  const double delta_c = c2 - c1;                                                              // (9)
  const double delta_h = 2 * std::sqrt(c1 * c2) * std::sin(hues.difference_deg / 2 * degree);  // (11)

  const double mean_l = (first.L + second.L) / 2;  // (12)
  const double mean_c_prime = (c1 + c2) / 2;       // (13)
  const double h = hues.mean_deg;
  const double t = 1 - 0.17 * std::cos((h - 30) * degree) + 0.24 * std::cos(2 * h * degree) +
                   0.32 * std::cos((3 * h + 6) * degree) - 0.20 * std::cos((4 * h - 63) * degree);  // (15)
  const double theta_deg = 30 * std::exp(-std::pow((h - 275) / 25, 2));                             // (16)
  const double r_c = 2 * seventh_power_share(mean_c_prime);                                         // (17)
  const double off_50 = (mean_l - 50) * (mean_l - 50);
  const double s_l = 1 + 0.015 * off_50 / std::sqrt(20 + off_50);  // (18)
  const double s_c = 1 + 0.045 * mean_c_prime;                     // (19)
  const double s_h = 1 + 0.015 * mean_c_prime * t;                 // (20)
  const double r_t = -std::sin(2 * theta_deg * degree) * r_c;      // (21)

  const double l = delta_l / s_l, c = delta_c / s_c, hue = delta_h / s_h;
  return std::sqrt(std::max(0.0, l * l + c * c + hue * hue + r_t * c * hue));  // (22)
}

}  // namespace shabon::color
