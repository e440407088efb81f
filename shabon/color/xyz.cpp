#include "shabon/color/xyz.h"

namespace shabon::color {

Xyz radiance_to_xyz(SpectrumView radiance, const Observer& observer) {
  Xyz sum;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    sum.x += radiance[i] * observer.x[i];
    sum.y += radiance[i] * observer.y[i];
    sum.z += radiance[i] * observer.z[i];
  }
  return sum;
}

Xyz reflectance_to_xyz(SpectrumView reflectance, const Illuminant& lamp, const Observer& observer) {
  Spectrum reflected;
  for (std::size_t i = 0; i < reflected.size(); ++i) reflected[i] = reflectance[i] * lamp.power[i];
  const Xyz sum = radiance_to_xyz(reflected, observer);
  const double perfect = radiance_to_xyz(lamp.power, observer).y;
  return {sum.x / perfect, sum.y / perfect, sum.z / perfect};
}

Xyz white_point(const Illuminant& lamp, const Observer& observer) {
  const Xyz sum = radiance_to_xyz(lamp.power, observer);
  return {sum.x / sum.y, 1, sum.z / sum.y};
}

Xy chromaticity(Xyz colour) {
  const double sum = colour.x + colour.y + colour.z;
  if (!(sum > 0)) return {};
  return {colour.x / sum, colour.y / sum};
}

}  // namespace shabon::color
