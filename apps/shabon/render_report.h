// What is told about a finished or interrupted render: in the picture's metadata, in --stats and on standard error.
#pragma once

#include <string>
#include <vector>

#include "scene_input.h"
#include "shabon/io/image.h"
#include "shabon/render/render.h"

namespace shabon::app {

// Stored in every picture: scene, seed, samples and version, so that it can be made again. No times: equal renders give
// equal files.
io::Metadata picture_metadata(const LoadedScene& loaded, const std::vector<std::string>& overrides,
                              const render::RenderReport& done);

std::string stats_json(const LoadedScene& loaded, const render::RenderReport& done);

// Light that was left out, and a picture without any.
Diagnostics render_warnings(const render::RenderReport& done, const render::Sensor& sensor);

// What a picture that was stopped early holds.
std::string interruption_message(const render::Sensor& sensor);

}  // namespace shabon::app
