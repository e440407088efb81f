#include "shabon/scene/film_parts.h"

#include "shabon/base/text.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

std::optional<optics::Stack> stack_at(const Path& place, const std::string& text,
                                      const optics::MediumResolver& resolver, Problems& problems) {
  if (problems.has(place)) return {};
  Result<optics::Stack> stack = optics::parse_stack(text, resolver);
  if (stack) return *std::move(stack);
  for (const Diagnostic& inner : stack.errors()) problems.add_from_text(place, inner);
  return {};
}

optics::Medium outer_medium(const optics::Medium& medium) {
  return medium.is_clear() ? medium.without_absorption() : medium;
}

bool check_coherent(const std::vector<optics::Layer>& layers, const Path& place, Problems& problems) {
  for (const optics::Layer& layer : layers) {
    if (!layer.coherent) {
      problems.add(place, "expected coherent layers, got an incoherent one of '" + layer.medium.name() +
                              "'; the surface 'pane' takes those");
      return false;
    }
    if (!film::thickness_range_nm.contains(layer.thickness_nm)) {
      problems.add(place, "expected a thickness of " + range_text({.unit = "nm", .range = film::thickness_range_nm}) +
                              ", got " + value_text(layer.thickness_nm));
      return false;
    }
  }
  return true;
}

bool check_varied(const VariedLayerDesc& vary, std::size_t layer_count, const Path& path, Problems& problems) {
  if (problems.has(path)) return false;
  if (vary.layer >= 1 && vary.layer <= static_cast<int>(layer_count)) return true;
  problems.add(path, "expected one of the " + std::to_string(layer_count) + " layers of the stack, got layer " +
                         std::to_string(vary.layer));
  return false;
}

std::optional<FilmParts> film_parts(const MediumFilmDesc& film, const Path& path,
                                    const optics::MediumResolver& resolver, Problems& problems) {
  const Path medium{&path, "medium"};
  if (problems.has(medium)) return {};
  if (trim(film.medium).empty()) {
    problems.add(medium, "expected the name of a medium or its index, got an empty text");
    return {};
  }
  // A medium alone is the shortest stack's first half; the expression's parser knows all ways to write one.
  const bool whole_stack = film.medium.find('|') != std::string::npos;
  const auto stack = whole_stack ? std::nullopt : stack_at(medium, film.medium + " | vacuum", resolver, problems);
  if (whole_stack)
    problems.add(medium, "expected one medium, got several layers; 'stack' takes them instead of 'medium'");
  if (!stack) return {};
  return FilmParts{optics::Medium(), {{stack->incidence, 0, true}}, 0, film.thickness, optics::Medium()};
}

std::optional<FilmParts> film_parts(const StackFilmDesc& film, const Path& path, const optics::MediumResolver& resolver,
                                    Problems& problems) {
  const Path place{&path, "stack"};
  const auto stack = stack_at(place, film.stack, resolver, problems);
  if (!stack) return {};
  if (stack->layers.empty()) {
    problems.add(place, "expected layers between two outer media, as in 'air | water 300nm | air', got none");
    return {};
  }
  if (!check_coherent(stack->layers, place, problems)) return {};
  const double first_nm = stack->layers.front().thickness_nm;
  FilmParts parts{outer_medium(stack->incidence), stack->layers, 0, film::ConstantThickness{first_nm},
                  outer_medium(stack->exit)};
  if (!film.vary) return parts;
  if (!check_varied(*film.vary, stack->layers.size(), Path{&path, "vary"}, problems)) return {};
  parts.varied_layer = static_cast<std::size_t>(film.vary->layer - 1);
  parts.thickness = film.vary->thickness;
  return parts;
}

void check_outer_media(const optics::Medium& outside, const optics::Medium& inside, const Path& place,
                       Problems& problems) {
  if (problems.has(place)) return;
  if (!(outside == inside))
    return problems.add(place, "expected the same medium outside and inside, got '" + outside.name() + "' and '" +
                                   inside.name() + "'; light crosses a film straight");
  if (!outside.is_lossless())
    problems.add(place, "expected an outer medium without absorption (k of at most " +
                            value_text(optics::most_k_of_clear) + "), got '" + outside.name() +
                            "'; light comes through it from any distance");
}

void check_model(const FilmParts& parts, optics::Interference model, const Path& path, Problems& problems) {
  const Path place{&path, "stack"};
  if (model == optics::Interference::airy || parts.layers.size() == 1 || problems.has(place)) return;
  problems.add(place, "expected one layer under 'interference: " + std::string(optics::name_of(model)) + "', got " +
                          std::to_string(parts.layers.size()) + "; 'interference: airy' takes any number");
}

}  // namespace shabon::scene
