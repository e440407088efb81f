#include "shabon/render/sensor.h"

#include <algorithm>

namespace shabon::render {

std::pair<std::uint32_t, std::uint32_t> Sensor::sample_range() const {
  if (pixels_.empty()) return {0, 0};
  const auto fewer = [](const Pixel& a, const Pixel& b) { return a.samples < b.samples; };
  const auto [low, high] = std::minmax_element(pixels_.begin(), pixels_.end(), fewer);
  return {low->samples, high->samples};
}

}  // namespace shabon::render
