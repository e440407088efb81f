// The files a picture is written to: their kinds, and the checks before the work begins.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/io/image.h"
#include "shabon/render/sensor.h"
#include "shabon/scene/development.h"

namespace shabon::app {

// How one kind of picture file is made from what the sensor holds.
struct PictureKind {
  std::string_view ending;  // ".png"
  std::string_view content;
  Status (*write)(const std::filesystem::path& path, const render::Sensor& sensor,
                  const scene::Development& development, const io::Metadata& metadata);
};

// The closed set.
std::span<const PictureKind> picture_kinds();

struct PictureFile {
  std::filesystem::path path;
  const PictureKind* kind = nullptr;
};

// By their endings. Errors of Failure::usage: an ending that is no kind of picture.
Result<std::vector<PictureFile>> picture_files(const std::vector<std::string>& names);

// That no output is also an input or another output (Failure::usage), and that each can be written (Failure::file).
Status check_outputs(std::span<const std::filesystem::path> outputs, std::span<const std::filesystem::path> inputs);

}  // namespace shabon::app
