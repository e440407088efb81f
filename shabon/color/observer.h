// Standard observers: colour-matching functions at 1 nm.
#pragma once

#include <span>
#include <string_view>

#include "shabon/color/spectrum.h"

namespace shabon::color {

struct Observer {
  std::string_view name, source;
  std::span<const double, 471> x, y, z;  // dimensionless; ybar is at most about 1
  std::string_view description;
};

// The CIE 1931 2 degree standard observer, used unless another one is asked for.
const Observer& observer_1931();

// All observers of the library; the default first.
std::span<const Observer> observers();

// By name, ignoring case; nullptr when unknown.
const Observer* find_observer(std::string_view name);

}  // namespace shabon::color
