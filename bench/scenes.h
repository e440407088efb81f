// The scenes that are rendered.
#pragma once

#include <string>

#include "shabon/base/result.h"
#include "shabon/scene/scene.h"

namespace shabon::bench {

// The built-in bubble.
Result<scene::Scene> built_in_bubble();

// bench/data/windows-bubble.yaml, with the picture of its environment turned.
Result<scene::Scene> windows_bubble(double rotation_deg = 0);

// The same bubble without its surroundings, of a film medium and an interference model, each as in a scene file.
Result<scene::Scene> plain_bubble(std::string_view medium, std::string_view interference);

// A white room with one lamp, coated spheres and a bubble.
Result<scene::Scene> coated_room();

// `count` bubbles of all sizes around each other under the windows; the same at every call.
Result<scene::Scene> many_bubbles(int count);

// The scene of that folder in scenes/.
Result<scene::Scene> gallery_scene(const std::string& name);

}  // namespace shabon::bench
