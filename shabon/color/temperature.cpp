#include "shabon/color/temperature.h"

#include <algorithm>
#include <cmath>

#include "shabon/color/planck.h"

namespace shabon::color {

namespace {

constexpr double meaningful_duv = 0.05;   // CIE 15:2018, 9.5
constexpr double reciprocal_scale = 1e6;  // temperatures are searched as 1e6/T, in which the locus is nearly uniform
constexpr double hottest = reciprocal_scale / 100'000, coldest = reciprocal_scale / 1000;
static_assert(blackbody_range_kelvin.low == 1000 && blackbody_range_kelvin.high == 100'000);

struct Uv {
  double u, v;
};

// CIE 1960.
Uv uv_of(Xy c) {
  const double divisor = -2 * c.x + 12 * c.y + 3;
  return {4 * c.x / divisor, 6 * c.y / divisor};
}

Uv blackbody_uv(double reciprocal) {
  return uv_of(chromaticity(radiance_to_xyz(blackbody_power(reciprocal_scale / reciprocal))));
}

double distance(Uv a, Uv b) { return std::hypot(a.u - b.u, a.v - b.v); }

// The minimum of a function that falls and then rises between low and high.
template <class Function>
double minimum_of(const Function& f, double low, double high) {
  constexpr double golden = 0.6180339887498949;  // (sqrt 5 - 1)/2
  constexpr int steps = 48;                      // narrows 60 units to 6e-9
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = f(a), fb = f(b);
  for (int i = 0; i < steps; ++i) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      a = high - golden * (high - low), fa = f(a);
    } else {
      low = a, a = b, fa = fb;
      b = low + golden * (high - low), fb = f(b);
    }
  }
  return (low + high) / 2;
}

}  // namespace

std::optional<ColorTemperature> correlated_color_temperature(Xy chromaticity) {
  const Uv wanted = uv_of(chromaticity);
  if (!std::isfinite(wanted.u) || !std::isfinite(wanted.v)) return {};
  constexpr int intervals = 33;  // of 30 reciprocal megakelvin
  constexpr double spacing = (coldest - hottest) / intervals;
  int nearest = 0;
  double nearest_distance = distance(wanted, blackbody_uv(hottest));
  for (int i = 1; i <= intervals; ++i) {
    const double here = distance(wanted, blackbody_uv(hottest + i * spacing));
    if (here < nearest_distance) nearest = i, nearest_distance = here;
  }
  const double low = hottest + std::max(nearest - 1, 0) * spacing;
  const double high = hottest + std::min(nearest + 1, intervals) * spacing;
  const double found = minimum_of([&](double r) { return distance(wanted, blackbody_uv(r)); }, low, high);
  const Uv locus = blackbody_uv(found);
  const double off = distance(wanted, locus);
  constexpr double end = 1e-6;  // the minimum lies at an end of the range when it is this near to it
  if (off > meaningful_duv || found < hottest + end || found > coldest - end) return {};
  return ColorTemperature{reciprocal_scale / found, std::copysign(off, wanted.v - locus.v)};
}

}  // namespace shabon::color
