// Lamps: relative spectral powers at 1 nm.
#pragma once

#include <span>
#include <string_view>

#include "shabon/color/observer.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

struct Illuminant {
  std::string_view name, description, source;
  std::span<const double, 471> power;  // relative power per nm, as published: 100 at 560 nm for CIE lamps
};

// All lamps of the library; D65 first.
std::span<const Illuminant> illuminants();

// By name, ignoring case; nullptr when unknown.
const Illuminant* find_illuminant(std::string_view name);

// The lamp's radiance per nm as seen directly at `scale: 1`: scaled so that the sum of L ybar at 1 nm is Y = 1.
Spectrum lamp_radiance(const Illuminant& lamp, const Observer& observer = observer_1931());

}  // namespace shabon::color
