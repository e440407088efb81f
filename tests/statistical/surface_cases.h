// Surfaces to test: for every kind of the list at least one, smooth and rough, bare and coated.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shabon/scene/scene.h"

namespace shabon::testing_surfaces {

struct SurfaceCase {
  std::string name;
  bool keeps_light = true;  // sends on all the light that arrives, to both sides together
  // How much of its light a whole object may lose where tables and chance are less exact.
  double may_lose = 0;
  // Adds the surface (and what it is made of) to the scene; its index.
  std::function<int(scene::Scene&)> add;
  bool solid = false;  // has an inside
};

std::vector<SurfaceCase> surface_cases();

// The letters and digits of its name.
std::string test_name(const SurfaceCase& surface);

// The kinds of scene::Surface that the cases hold, by index.
std::vector<bool> kinds_covered();

// A scene with a constant light of Y = 1 and nothing in it, a pinhole camera at (0, 0, 5) that looks at the origin.
scene::Scene lit_from_everywhere(int width, int height, double vertical_fov_deg);

// Puts a shape with the surface of that index into the scene.
void add_object(scene::Scene& scene, const geometry::Shape& shape, const geometry::Affine& place, int surface);

}  // namespace shabon::testing_surfaces
