// What lies on a boundary between two media: any coherent stack, of which one layer may vary over the surface.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "shabon/film/thickness.h"
#include "shabon/optics/stack.h"
#include "shabon/scene/texture.h"

namespace shabon::scene {

struct Coating {
  // From the front, the side the shape's normal points to. The medium in front is lossless.
  optics::Stack stack;
  struct Varied {
    std::size_t layer = 0;
    std::variant<film::ThicknessModel, NumberTexture> thickness_nm;
  };
  std::optional<Varied> varied;  // in place of the thickness in the stack
};

}  // namespace shabon::scene
