// The compiled scene: immutable, checked, in the renderer's terms. compile() makes it from a SceneDesc.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "shabon/color/spectrum.h"
#include "shabon/film/flow/parameters.h"
#include "shabon/film/popping.h"
#include "shabon/film/thickness_field.h"
#include "shabon/geometry/shape.h"
#include "shabon/math/vec.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack.h"
#include "shabon/scene/camera.h"
#include "shabon/scene/development.h"
#include "shabon/scene/environment.h"
#include "shabon/scene/pixel_filter.h"
#include "shabon/scene/surface.h"

namespace shabon::scene {

// How a simulated film bursts: where and when it breaks by itself if it is one of those, else where and when it is
// told.
struct Bursting {
  film::BubbleBody body;  // thickness_m 0: the mean of the film when it breaks
  film::PoppingDesc popping;
  bool by_itself = false;
};

// The liquid that a bursting film has gathered at the edge of its hole.
struct Rim {
  math::Vec3d axis;      // unit, from the bubble's centre to the hole's middle
  double angle_rad = 0;  // from there to the edge of the film
  double thickness = 0;  // radius of the rim's round section, in radii of the bubble
};

// One film between the scene's medium on both sides: coherent layers from the outside to the inside, at least one, of
// which one has a thickness of its own at each place.
struct Film {
  std::vector<optics::Layer> layers;
  std::size_t varied_layer = 0;                        // index into layers
  film::ThicknessField thickness;                      // of that layer, in place of the one written there
  std::optional<NumberTexture> thickness_map_nm = {};  // by (u, v), in place of `thickness`; never on bubbles
  std::shared_ptr<const film::FlowDesc> flow = {};     // RunningFilms sets `thickness`; on bubbles only
  std::optional<Bursting> bursting = {};               // beside `flow`
  std::optional<Rim> rim = {};                         // until add_rims() makes an object of it
};

// Bubbles with the same centre and radius are one sphere with several films, listed outermost first in the order of
// the objects: films[first_film .. first_film + film_count).
struct Sphere {
  math::Vec3d center;
  double radius = 1;
  int first_film = 0;
  int film_count = 1;
  int place_in_file = 0;  // of the first film: index into the scene file's objects, for messages
};

// Anything that is not a round bubble.
struct Object {
  geometry::PlacedShape shape;
  int surface = 0;        // Scene::surfaces
  int place_in_file = 0;  // index into the scene file's objects, for messages
};

// How the tree of paths is followed.
enum class Transport {
  tree,  // both branches at a film, then one path from the first surface on that scatters
  path,  // one path throughout: slow, kept as a check
};

struct RenderSettings {
  int samples = 64;
  std::uint64_t seed = 1;
  optics::Interference interference = optics::Interference::airy;
  Transport transport = Transport::tree;
  double split_threshold = 1e-3;
  int max_depth = 64;
};

struct Scene {
  double time_s = 0;  // the moment it shows: films are as they are then
  int width = 800, height = 600;
  Camera camera;
  PixelFilter filter;
  Development development;
  RenderSettings render;
  optics::Medium medium = optics::Medium::constant(1.0);  // fills all space, inside and outside of bubbles
  std::vector<Sphere> spheres;
  std::vector<Film> films;
  std::vector<Object> objects;
  std::vector<Surface> surfaces;
  std::vector<color::Spectrum> reflectances;  // 0..1 at 1 nm
  double metres_per_unit = 1;                 // how long the scene's unit is, for the absorption in solids
  Environment environment;
};

// Whether a simulated film has no thickness yet: RunningFilms gives it one.
inline bool has_idle_film(const Scene& scene) {
  for (const Film& film : scene.films)
    if (film.flow && std::holds_alternative<film::ConstantThickness>(film.thickness)) return true;
  return false;
}

}  // namespace shabon::scene
