// The light that comes from infinity: one base light and any softboxes on top. Their spectra are a short list of
// channels, so that the radiance of a direction is one small coefficient per channel.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "shabon/color/spectrum.h"
#include "shabon/math/vec.h"
#include "shabon/scene/lights/constant_light.h"
#include "shabon/scene/lights/gradient_light.h"
#include "shabon/scene/lights/image_light.h"
#include "shabon/scene/lights/sky_light.h"
#include "shabon/scene/lights/softbox.h"

namespace shabon::scene {

// The closed set of base lights.
using BaseLight = std::variant<ConstantLight, GradientLight, ImageLight, SkyLight>;

struct Environment {
  std::vector<color::Spectrum> channels;  // radiance per nm at 1 nm; a lamp of scale 1 has Y = 1
  BaseLight base = ConstantLight{};
  std::vector<Softbox> softboxes;

  // Writes the coefficient of every channel for light that comes from `direction` (unit, away from the scene).
  // T is double, or a packet of numbers for as many directions.
  template <class T>
  void coefficients(const math::Vec3<T>& direction, std::span<T> result) const {
    for (T& value : result) value = T(0);
    std::visit([&](const auto& light) { light.add(direction, result.data()); }, base);
    for (const Softbox& softbox : softboxes)
      std::visit([&](const auto& light) { light.add(direction, result.data()); }, softbox);
  }
};

}  // namespace shabon::scene
