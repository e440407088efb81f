// Surface: reflects alike into all directions (Lambert), on both sides.
#pragma once

#include <optional>
#include <tuple>

#include "shabon/scene/color_desc.h"
#include "shabon/scene/texture.h"
#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

class SurfaceCompiler;

struct DiffuseSurface {
  ReflectanceTexture color;
};

// A reflectance.
struct BaseColorDesc {
  ColorDesc color;
  std::optional<ColorMapDesc> color_map = {};
};

constexpr auto fields(Of<BaseColorDesc>) {
  return std::tuple{
      Field{
          "color",
          &BaseColorDesc::color,
          {.doc =
               "\"#rrggbb\" is encoded sRGB, [r, g, b] linear sRGB, a number the same at all wavelengths, file:PATH a "
               "table of wavelength_nm and reflectance"}},
      Field{"color_map", &BaseColorDesc::color_map, {.doc = "a picture in place of the colour"}}};
}

struct DiffuseSurfaceDesc : BaseColorDesc {};

constexpr About about(Of<DiffuseSurfaceDesc>) {
  return {.name = "diffuse", .doc = "reflects alike into all directions, on both sides"};
}
constexpr auto fields(Of<DiffuseSurfaceDesc>) { return fields(Of<BaseColorDesc>{}); }

void check(const DiffuseSurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<DiffuseSurface> compile(const DiffuseSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
