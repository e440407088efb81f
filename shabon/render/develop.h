// From the sensor to a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/color/gamut.h"
#include "shabon/io/image.h"
#include "shabon/render/sensor.h"
#include "shabon/scene/development.h"

namespace shabon::render {

// Linear sRGB, unclipped: film colours outside sRGB have negative components. No exposure, no white balance.
io::RgbImage develop_linear(const Sensor& sensor);

// Encoded sRGB, 8 bits, rows top to bottom. White balance first, then the exposure, then colours outside sRGB are
// mapped into it. Half-way values round up; no dither.
std::vector<std::uint8_t> develop_srgb8(const Sensor& sensor, const scene::Development& development,
                                        color::GamutMapping mapping = color::default_gamut_mapping);

}  // namespace shabon::render
