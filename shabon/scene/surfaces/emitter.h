// Surface: a lamp that shines alike into all directions of its front, or of both sides. It reflects nothing.
#pragma once

#include <optional>
#include <tuple>

#include "shabon/scene/lamp_desc.h"

namespace shabon::scene {

class SurfaceCompiler;

struct EmitterSurface {
  int channel = 0;  // of Environment::channels
  double scale = 1;
  bool both_sides = false;
};

struct EmitterSurfaceDesc : LampDesc {
  bool both_sides = false;
};

constexpr About about(Of<EmitterSurfaceDesc>) { return {.name = "emitter", .doc = "a lamp; it reflects nothing"}; }
constexpr auto fields(Of<EmitterSurfaceDesc>) {
  return std::tuple_cat(
      fields(Of<LampDesc>{}),
      std::tuple{Field{"both_sides",
                       &EmitterSurfaceDesc::both_sides,
                       {.doc = "whether its back shines too; the front is where the normal points"}}});
}

void check(const EmitterSurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<EmitterSurface> compile(const EmitterSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
