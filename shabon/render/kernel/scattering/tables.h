// What the kernel needs of a scene with surfaces, per wavelength comb: made once before the first pass.
#pragma once

#include <memory>
#include <vector>

#include "shabon/geometry/shape_set.h"
#include "shabon/render/kernel/scattering/coating_table.h"
#include "shabon/render/kernel/scattering/pane_table.h"
#include "shabon/render/kernel/scene_tables.h"
#include "shabon/render/lamp_sampling.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// A medium that light runs through between two surfaces.
struct SpaceTable {
  bool absorbs = false;
  std::vector<Lanes> log2_loss_per_unit;  // per comb: log2 of what is left after one of the scene's units
};

struct SurfaceTable {
  std::unique_ptr<CoatingTable> coating;
  std::unique_ptr<PaneTable> pane;
};

// A shape of the scene: the objects in their order, then the bubbles.
struct ShapeTable {
  int surface = -1;  // Scene::surfaces, or -1 for a bubble
  int first_film = 0, film_count = 0;
  int object = -1;  // Scene::objects
};

struct ScatteringTables {
  explicit ScatteringTables(const scene::Scene& scene, std::optional<std::vector<Comb>> combs = {});

  const scene::Scene& scene;
  SceneTables films;  // films, combs and lamps as the bubble kernel has them
  geometry::ShapeSet shapes;
  std::vector<ShapeTable> shape;
  std::vector<SurfaceTable> surfaces;
  std::vector<SpaceTable> spaces;  // 0 is the scene's medium
  std::size_t reflectance_count = 0;
  std::vector<Lanes> reflectances;  // [comb * reflectance_count + channel]
  LampSampling lamps;
  int camera_space = 0;  // where the camera stands
  // Some medium fades light, and the camera's rays begin in more than one place: each has to look where it is.
  bool camera_spaces_differ = false;
};

// The medium around a point: that on the near side of the first boundary in that direction, the scene's where there is
// none.
int space_at(const ScatteringTables& tables, math::Vec3d origin, math::Vec3d direction);

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
