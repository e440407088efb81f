// Media that do not meet: solids that nothing closes, and surfaces that face each other across two media.
#pragma once

#include <optional>
#include <vector>

#include "shabon/scene/scene.h"

namespace shabon::scene {

// Objects are counted through Scene::objects, then Scene::spheres.
struct MediaFlaw {
  int object = 0;            // its surface is a dielectric
  std::optional<int> other;  // that faces it; none where light leaves the scene
  optics::Medium here;       // on the object's side that is wrong
  optics::Medium there;      // on the other's side; of the scene where there is none
  bool behind = false;       // the object's back, where its stack ends
};

// From points of each dielectric's two sides a few straight lines are followed to what they meet next. A flaw is where
// more than one line in ten arrives in another medium; each pair of objects is listed once. Of very large scenes
// (20 000 objects, 1000 dielectrics) not all is looked at.
std::vector<MediaFlaw> media_flaws(const Scene& scene);

}  // namespace shabon::scene
