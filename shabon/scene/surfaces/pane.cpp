#include "shabon/scene/surfaces/pane.h"

#include <algorithm>

#include "shabon/scene/compile_surfaces.h"
#include "shabon/scene/film_parts.h"

namespace shabon::scene {

std::optional<PaneSurface> compile(const PaneSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  const Path place{&path, "stack"};
  Problems& problems = compiler.problems();
  const std::optional<optics::Stack> stack = compiler.stack(surface.stack, path);
  if (!stack) return {};
  if (stack->layers.empty()) {
    problems.add(place, "expected layers between two outer media, as in 'air | glass 3mm incoherent | air', got none");
    return {};
  }
  std::vector<optics::Layer> coherent;
  std::copy_if(stack->layers.begin(), stack->layers.end(), std::back_inserter(coherent),
               [](const optics::Layer& layer) { return layer.coherent; });
  check_coherent(coherent, place, problems);
  check_outer_media(outer_medium(stack->incidence), outer_medium(stack->exit), place, problems);
  const optics::Interference model = compiler.interference();
  if (model != optics::Interference::airy && !coherent.empty())
    problems.add(place, "expected no coherent layers under 'interference: " + std::string(optics::name_of(model)) +
                            "', which knows free films only; 'interference: airy' takes any number");
  compiler.media().fills_space(outer_medium(stack->incidence), place);
  return PaneSurface{{outer_medium(stack->incidence), stack->layers, outer_medium(stack->exit)}};
}

}  // namespace shabon::scene
