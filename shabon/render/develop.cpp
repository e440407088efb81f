#include "shabon/render/develop.h"

#include <cmath>

#include "shabon/color/rgb.h"

namespace shabon::render {

namespace {

template <class Function>
void for_each_pixel(const Sensor& sensor, const Function& function) {
  for (int y = 0; y < sensor.height(); ++y)
    for (int x = 0; x < sensor.width(); ++x) function(sensor.mean(x, y));
}

}  // namespace

io::RgbImage develop_linear(const Sensor& sensor) {
  io::RgbImage image;
  image.width = sensor.width(), image.height = sensor.height();
  image.rgb.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for_each_pixel(sensor, [&](const color::Xyz& mean) {
    const color::LinearRgb c = color::xyz_to_linear_srgb(mean);
    for (const double value : {c.r, c.g, c.b}) image.rgb.push_back(static_cast<float>(value));
  });
  return image;
}

std::vector<std::uint8_t> develop_srgb8(const Sensor& sensor, const scene::Development& development,
                                        color::GamutMapping mapping) {
  const double exposure = std::exp2(development.exposure_ev);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * static_cast<std::size_t>(sensor.width()) * static_cast<std::size_t>(sensor.height()));
  for_each_pixel(sensor, [&](const color::Xyz& mean) {
    const color::LinearRgb c = color::xyz_to_linear_srgb(development.balanced(mean));
    const color::LinearRgb mapped = color::map_to_srgb_gamut({c.r * exposure, c.g * exposure, c.b * exposure}, mapping);
    const color::EncodedRgb encoded = color::encode_srgb(mapped);
    for (const double value : {encoded.r, encoded.g, encoded.b})
      bytes.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
  });
  return bytes;
}

}  // namespace shabon::render
