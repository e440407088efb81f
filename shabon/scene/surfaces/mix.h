// Surfaces made of other ones: two side by side below what the eye resolves, or one with holes.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "shabon/base/indirect.h"
#include "shabon/scene/texture.h"
#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

class SurfaceCompiler;
struct SurfaceDesc;

struct MixSurface {
  int first = 0, second = 0;  // Scene::surfaces, both listed before this one
  NumberTexture amount;       // of the second, 0..1
};

struct MaskSurface {
  int surface = 0;  // Scene::surfaces, listed before this one
  NumberTexture opacity;
};

struct MixSurfaceDesc {
  std::vector<SurfaceDesc> surfaces;  // two
  double amount = 0.5;
  std::optional<NumberMapDesc> amount_map = {};
};

struct MaskSurfaceDesc {
  Indirect<SurfaceDesc> surface;
  double opacity = 1;
  std::optional<NumberMapDesc> opacity_map = {};
};

constexpr About about(Of<MixSurfaceDesc>) {
  return {.name = "mix", .doc = "two surfaces side by side, finer than is seen"};
}
constexpr auto fields(Of<MixSurfaceDesc>) {
  return std::tuple{
      Field{"surfaces", &MixSurfaceDesc::surfaces, {.required = true, .items = 2, .doc = "the two surfaces"}},
      Field{"amount", &MixSurfaceDesc::amount, {.range = share_range, .doc = "share of the second"}},
      Field{"amount_map", &MixSurfaceDesc::amount_map, {.doc = "a picture in place of the number"}}};
}

constexpr About about(Of<MaskSurfaceDesc>) { return {.name = "mask", .doc = "a surface with holes"}; }
constexpr auto fields(Of<MaskSurfaceDesc>) {
  return std::tuple{
      Field{"surface", &MaskSurfaceDesc::surface, {.required = true, .doc = "what there is between the holes"}},
      Field{"opacity", &MaskSurfaceDesc::opacity, {.range = share_range, .doc = "share that is not a hole"}},
      Field{"opacity_map", &MaskSurfaceDesc::opacity_map, {.doc = "a picture in place of the number"}}};
}

void check(const MixSurfaceDesc& surface, const Path& path, Problems& problems);
void check(const MaskSurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<MixSurface> compile(const MixSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);
std::optional<MaskSurface> compile(const MaskSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
