// From the sensor to a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/color/gamut.h"
#include "shabon/io/image.h"
#include "shabon/render/sensor.h"

namespace shabon::render {

// Linear sRGB, unclipped: film colours outside sRGB have negative components.
io::RgbImage develop_linear(const Sensor& sensor);

// Encoded sRGB, 8 bits, rows top to bottom. The exposure multiplies by 2^exposure_ev; then colours outside sRGB are
// mapped into it. Half-way values round up; no dither.
std::vector<std::uint8_t> develop_srgb8(const Sensor& sensor, double exposure_ev, color::GamutMapping mapping);

}  // namespace shabon::render
