#include "shabon/color/daylight.h"

#include <algorithm>
#include <cmath>

#include "shabon/color/table_columns.h"

// The numbers of this file: CIE 15:2018, Colorimetry, 4th edition, section 4.1.2 (equations 4.7 to 4.12); D. B. Judd,
// D. L. MacAdam, G. Wyszecki, "Spectral distribution of typical daylight as a function of correlated color
// temperature", J. Opt. Soc. Am. 54 (1964) 1031.
namespace shabon::color {

namespace {

double rounded(double value) { return std::round(value * 1000) / 1000; }

// What `at_row` says of the components' rows, with straight lines between them.
template <class AtRow>
Spectrum at_each_nm(const AtRow& at_row) {
  const auto nm = tables::daylight().front().columns[0];
  Spectrum result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double lambda = wavelength_nm(i);
    const auto above = std::lower_bound(nm.begin(), nm.end(), lambda);
    const auto right = static_cast<std::size_t>(above - nm.begin());
    if (*above == lambda) {
      result[i] = at_row(right);
      continue;
    }
    const double share = (lambda - nm[right - 1]) / (nm[right] - nm[right - 1]);
    result[i] = at_row(right - 1) + share * (at_row(right) - at_row(right - 1));
  }
  return result;
}

}  // namespace

Xy daylight_chromaticity(double temperature_kelvin) {
  const double u = 1e3 / temperature_kelvin;  // the published powers of ten are those of 1/T
  constexpr double seam_kelvin = 7000;
  const double x = temperature_kelvin <= seam_kelvin ? ((-4.6070 * u + 2.9678) * u + 0.09911) * u + 0.244063
                                                     : ((-2.0064 * u + 1.9018) * u + 0.24748) * u + 0.237040;
  return {x, (-3.000 * x + 2.870) * x - 0.275};
}

Spectrum daylight_power(double temperature_kelvin, DaylightWeights weights) {
  const Xy d = daylight_chromaticity(temperature_kelvin);
  const double divisor = 0.0241 + 0.2562 * d.x - 0.7341 * d.y;
  double m1 = (-1.3515 - 1.7703 * d.x + 5.9114 * d.y) / divisor;
  double m2 = (0.0300 - 31.4424 * d.x + 30.0717 * d.y) / divisor;
  if (weights == DaylightWeights::three_decimals) {
    m1 = rounded(m1);
    m2 = rounded(m2);
  }
  const Table& components = tables::daylight().front();
  const auto s0 = components.columns[1], s1 = components.columns[2], s2 = components.columns[3];
  return at_each_nm([&](std::size_t row) { return s0[row] + m1 * s1[row] + m2 * s2[row]; });
}

std::array<Spectrum, 3> daylight_components() {
  std::array<Spectrum, 3> result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = at_each_nm([&](std::size_t row) { return tables::daylight().front().columns[1 + k][row]; });
  return result;
}

}  // namespace shabon::color
