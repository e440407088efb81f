// What lies on a boundary between two media: any coherent stack, of which one layer may vary over the surface.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "shabon/film/thickness_field.h"
#include "shabon/optics/stack.h"
#include "shabon/scene/film_desc.h"
#include "shabon/scene/texture.h"

namespace shabon::scene {

// Outside of Coating: clang 14 does not know an inner struct's defaults in time.
struct VariedLayer {
  std::size_t layer = 0;
  std::variant<film::ThicknessField, NumberTexture> thickness_nm;
};

struct Coating {
  // From the front, the side the shape's normal points to. The medium in front is transparent: its k stays below
  // transparent_extinction at all rendered wavelengths.
  optics::Stack stack;
  std::optional<VariedLayer> varied;  // in place of the thickness in the stack
};

// Of a medium that light may travel through. Here the light falls to 1/e within 40 micrometres of it.
inline constexpr double transparent_extinction = 1e-3;

struct CoatingDesc {
  std::string stack = "air | glass";  // front | layers, perhaps none | back
  std::optional<VariedLayerDesc> vary = {};
};

constexpr auto fields(Of<CoatingDesc>) {
  return std::tuple{Field{"stack",
                          &CoatingDesc::stack,
                          {.required = true,
                           .doc = "front | coherent layers, perhaps none | back, as in \"air | MgF2 99nm | glass\""}},
                    Field{"vary", &CoatingDesc::vary, {.doc = "one of the layers and how thick it is, and where"}}};
}

// GGX alpha.
struct RoughnessDesc {
  double roughness = 0;
  std::optional<NumberMapDesc> roughness_map = {};
};

constexpr auto fields(Of<RoughnessDesc>) {
  return std::tuple{
      Field{"roughness", &RoughnessDesc::roughness, {.range = share_range, .doc = "GGX alpha; 0 is smooth"}},
      Field{"roughness_map", &RoughnessDesc::roughness_map, {.doc = "a picture in place of the number"}}};
}

}  // namespace shabon::scene
