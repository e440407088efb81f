// The compiled scene: immutable, checked, in the renderer's terms. compile() makes it from a SceneDesc.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/film/thickness.h"
#include "shabon/math/vec.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack.h"
#include "shabon/scene/camera.h"
#include "shabon/scene/environment.h"

namespace shabon::scene {

// One film between the scene's medium on both sides: coherent layers from the outside to the inside, at least one, of
// which one has a thickness of its own at each place.
struct Film {
  std::vector<optics::Layer> layers;
  std::size_t varied_layer = 0;    // index into layers
  film::ThicknessModel thickness;  // of that layer, in place of the one written there
};

// Bubbles with the same centre and radius are one sphere with several films, listed outermost first in the order of
// the objects: films[first_film .. first_film + film_count).
struct Sphere {
  math::Vec3d center;
  double radius = 1;
  int first_film = 0;
  int film_count = 1;
};

struct RenderSettings {
  int samples = 64;
  std::uint64_t seed = 1;
  optics::Interference interference = optics::Interference::airy;
  double split_threshold = 1e-3;
  int max_depth = 64;
};

struct Scene {
  int width = 800, height = 600;
  Camera camera;
  RenderSettings render;
  optics::Medium medium = optics::Medium::constant(1.0);  // fills all space, inside and outside of bubbles
  std::vector<Sphere> spheres;
  std::vector<Film> films;
  Environment environment;
};

}  // namespace shabon::scene
