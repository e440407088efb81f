// A lamp as a scene file names it.
#pragma once

#include <string>
#include <tuple>

#include "shabon/base/field.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/ranges.h"

namespace shabon::scene {

// A lamp's spectrum, `scale` times as bright as one seen directly with Y = 1.
struct LampDesc {
  std::string illuminant = "D65";
  double scale = 1;
};

constexpr auto fields(Of<LampDesc>) {
  return std::tuple{
      Field{"illuminant",
            &LampDesc::illuminant,
            {.doc = "lamp that gives the spectrum: a name such as D65, A, FL11, LED-B3 (`shabon lamps` lists them), "
                    "blackbody:3000K, daylight:5000K, or file:PATH"}},
      Field{"scale", &LampDesc::scale, {.range = scale_range, .doc = "brightness; 1 has Y = 1 when seen directly"}}};
}

void check(const LampDesc& lamp, const Path& path, Problems& problems);

}  // namespace shabon::scene
