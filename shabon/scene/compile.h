// SceneDesc -> Scene: everything checked, looked up and put into the renderer's terms.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/scene/resources.h"
#include "shabon/scene/scene.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

// Whether the camera must stand where it can see: off every surface.
enum class CameraUse { takes_pictures, none };

// Checks the description by the same lists and rules as read_scene() (one may be written in code), finds its media and
// pictures, and builds the scene. Errors, all at once and with their places when the description came from a file:
// values out of range; unknown media; films of several layers; outer media that absorb or differ, across a film or
// between films; what the resources report. Warnings, if wanted, are added: one for each medium that is used outside
// the range of its source, one for negative values of a picture.
Result<Scene> compile(const SceneDesc& description, const Resources& resources, Diagnostics* warnings = nullptr,
                      CameraUse camera = CameraUse::takes_pictures);

// From the text of a scene file to the scene in one call: parse_yaml, apply_override for each of `overrides`
// ("path=value"), read_scene and compile. Unlike those one after the other it reports the problems of the file and
// those of the files it names together.
Result<Scene> load_scene(std::string_view text, std::string source, std::span<const std::string> overrides,
                         const Resources& resources, Diagnostics* warnings = nullptr,
                         CameraUse camera = CameraUse::takes_pictures);

}  // namespace shabon::scene
