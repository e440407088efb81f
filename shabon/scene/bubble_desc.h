// A bubble as a scene file states it: where it is, what its film is made of, and what its shape does in time.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/film/popping.h"
#include "shabon/film/shape_modes.h"
#include "shabon/math/vec.h"
#include "shabon/scene/film_desc.h"
#include "shabon/scene/ranges.h"

namespace shabon::scene {

// What its frequencies and the speed of its bursting follow from.
struct BodyDesc {
  std::optional<double> radius_m = {};
  std::optional<double> thickness_nm = {};
  double tension_n_m = film::BubbleBody{}.tension_n_m;
  double density_kg_m3 = film::BubbleBody{}.density_kg_m3;
  double inner_air_kg_m3 = film::BubbleBody{}.inner_air_kg_m3;
  double outer_air_kg_m3 = film::BubbleBody{}.outer_air_kg_m3;
};

struct BubbleDesc {
  math::Vec3d center{0, 0, 0};
  double radius = 1;
  FilmDesc film = {};
  std::vector<film::ShapeMode> modes = {};
  std::optional<film::PoppingDesc> popping = {};
  BodyDesc body = {};
};

constexpr auto fields(Of<BodyDesc>) {
  constexpr Range length{.low = 1e-6, .high = 100}, film_nm{.low = 1, .high = 1e6};
  constexpr Range tension{.low = 1e-4, .high = 1}, density{.low = 1, .high = 1e5}, air{.low = 0, .high = 1e4};
  return std::tuple{Field{"radius_m",
                          &BodyDesc::radius_m,
                          {.unit = "m",
                           .range = length,
                           .unset = "radius times metres_per_unit",
                           .doc = "radius in nature; that of `flow` where it is simulated"}},
                    Field{"thickness_nm",
                          &BodyDesc::thickness_nm,
                          {.unit = "nm",
                           .range = film_nm,
                           .unset = "the mean of the film",
                           .doc = "mean thickness; needed where the film is a picture"}},
                    Field{"tension_n_m",
                          &BodyDesc::tension_n_m,
                          {.unit = "N/m", .range = tension, .doc = "surface tension of one side of the film"}},
                    Field{"density_kg_m3",
                          &BodyDesc::density_kg_m3,
                          {.unit = "kg/m^3", .range = density, .doc = "density of the liquid"}},
                    Field{"inner_air_kg_m3",
                          &BodyDesc::inner_air_kg_m3,
                          {.unit = "kg/m^3", .range = air, .doc = "density of the gas inside"}},
                    Field{"outer_air_kg_m3",
                          &BodyDesc::outer_air_kg_m3,
                          {.unit = "kg/m^3", .range = air, .doc = "density of the gas outside"}}};
}

constexpr About about(Of<BubbleDesc>) { return {.name = "bubble", .doc = "a film on a sphere"}; }
constexpr auto fields(Of<BubbleDesc>) {
  return std::tuple{Field{"center", &BubbleDesc::center, {.range = coordinate_range, .doc = "its centre"}},
                    Field{"radius", &BubbleDesc::radius, {.range = radius_range, .doc = "its radius"}},
                    Field{"film", &BubbleDesc::film, {.required = true, .doc = "what it is made of"}},
                    Field{"modes", &BubbleDesc::modes, {.doc = "how it trembles from time 0 on, (89)-(91)"}},
                    Field{"popping",
                          &BubbleDesc::popping,
                          {.doc = "it bursts: a hole opens, (92)-(94), until nothing is left; of a `flow` with "
                                  "`rupture` where and when it breaks"}},
                    Field{"body", &BubbleDesc::body, {.doc = "the bubble in nature, for how fast it moves"}}};
}

void check(const film::ShapeMode& mode, const Path& path, Problems& problems);
void check(const film::PoppingDesc& popping, const Path& path, Problems& problems);

}  // namespace shabon::scene
