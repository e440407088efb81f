#include "shabon/scene/film_parts.h"

#include "shabon/base/text.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

std::optional<optics::Stack> understood(Result<optics::Stack> stack, const Path& path, Problems& problems) {
  if (stack) return *std::move(stack);
  for (const Diagnostic& inner : stack.errors()) problems.add_from_text(path, inner);
  return {};
}

// What the renderer supports.
bool check_layers(const std::vector<optics::Layer>& layers, const Path& place, Problems& problems) {
  if (layers.empty()) {
    problems.add(place, "expected layers between two outer media, as in 'air | water 300nm | air', got none");
    return false;
  }
  for (const optics::Layer& layer : layers) {
    if (!layer.coherent) {
      problems.add(place, "expected coherent layers, got an incoherent one of '" + layer.medium.name() +
                              "'; the renderer supports coherent films");
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

// What is clear fills a scene as if it absorbed nothing, however far the light goes.
optics::Medium outer(const optics::Medium& medium) { return medium.is_clear() ? medium.without_absorption() : medium; }

}  // namespace

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
  const auto stack = whole_stack
                         ? std::nullopt
                         : understood(optics::parse_stack(film.medium + " | vacuum", resolver), medium, problems);
  if (whole_stack)
    problems.add(medium, "expected one medium, got several layers; 'stack' takes them instead of 'medium'");
  if (!stack) return {};
  return FilmParts{optics::Medium(), {{{stack->incidence, 0, true}}, 0, film.thickness}, optics::Medium()};
}

std::optional<FilmParts> film_parts(const StackFilmDesc& film, const Path& path, const optics::MediumResolver& resolver,
                                    Problems& problems) {
  const Path place{&path, "stack"};
  if (problems.has(place)) return {};
  const auto stack = understood(optics::parse_stack(film.stack, resolver), place, problems);
  if (!stack) return {};
  if (!check_layers(stack->layers, place, problems)) return {};
  if (!film.vary)
    return FilmParts{outer(stack->incidence),
                     {stack->layers, 0, film::ConstantThickness{stack->layers.front().thickness_nm}},
                     outer(stack->exit)};
  const Path vary{&path, "vary"};
  if (problems.has(vary)) return {};
  if (film.vary->layer < 1 || film.vary->layer > static_cast<int>(stack->layers.size())) {
    problems.add(vary, "expected one of the " + std::to_string(stack->layers.size()) +
                           " layers of the stack, got layer " + std::to_string(film.vary->layer));
    return {};
  }
  return FilmParts{outer(stack->incidence),
                   {stack->layers, static_cast<std::size_t>(film.vary->layer - 1), film.vary->thickness},
                   outer(stack->exit)};
}

void check_outer_media(const FilmParts& parts, const Path& path, Problems& problems) {
  const Path place{&path, "stack"};
  if (problems.has(place)) return;
  if (!(parts.outside == parts.inside))
    return problems.add(place, "expected the same medium outside and inside, got '" + parts.outside.name() + "' and '" +
                                   parts.inside.name() + "'; a bubble floats in one medium");
  if (!parts.outside.is_lossless())
    problems.add(place, "expected an outer medium without absorption (k of at most " +
                            value_text(optics::most_k_of_clear) + "), got '" + parts.outside.name() +
                            "'; light reaches the film through it from any distance");
}

void check_model(const FilmParts& parts, optics::Interference model, const Path& path, Problems& problems) {
  const Path place{&path, "stack"};
  if (model == optics::Interference::airy || parts.film.layers.size() == 1 || problems.has(place)) return;
  problems.add(place, "expected one layer under 'interference: " + std::string(optics::name_of(model)) + "', got " +
                          std::to_string(parts.film.layers.size()) + "; 'interference: airy' takes any number");
}

}  // namespace shabon::scene
