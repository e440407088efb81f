#include "shabon/color/rgb_basis.h"

#include <algorithm>

#include "shabon/color/illuminant.h"
#include "shabon/color/table_columns.h"

namespace shabon::color {

namespace {

Spectrum copy(SpectrumView values) {
  Spectrum spectrum;
  std::copy(values.begin(), values.end(), spectrum.begin());
  return spectrum;
}

}  // namespace

const RgbBasis& rgb_basis() {
  static const RgbBasis basis = [] {
    const Table& table = tables::rgb_basis().front();
    return RgbBasis{copy(spectrum_column(table, 1)), copy(spectrum_column(table, 2)), copy(spectrum_column(table, 3))};
  }();
  return basis;
}

Spectrum rgb_to_reflectance(LinearRgb colour) {
  const RgbBasis& basis = rgb_basis();
  Spectrum spectrum;
  for (std::size_t i = 0; i < spectrum.size(); ++i)
    spectrum[i] = colour.r * basis.r[i] + colour.g * basis.g[i] + colour.b * basis.b[i];
  return spectrum;
}

Spectrum rgb_to_radiance(LinearRgb colour) {
  static const Spectrum lamp = lamp_radiance(*find_illuminant("D65"));
  Spectrum spectrum = rgb_to_reflectance(colour);
  for (std::size_t i = 0; i < spectrum.size(); ++i) spectrum[i] *= lamp[i];
  return spectrum;
}

}  // namespace shabon::color
