#include "picture_files.h"

#include <fmt/format.h>

#include <system_error>

#include "shabon/base/text.h"
#include "shabon/color/gamut.h"
#include "shabon/io/file.h"
#include "shabon/render/develop.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

Status write_png(const fs::path& path, const render::Sensor& sensor, const scene::Development& development,
                 const io::Metadata& metadata) {
  io::Metadata told = metadata;
  told.emplace_back("exposure_ev", format_number(development.exposure_ev));
  told.emplace_back("white_balance", development.white_lamp);
  return io::write_png(path, sensor.width(), sensor.height(), render::develop_srgb8(sensor, development), told);
}

// Before exposure and white balance: what is added to other light, or developed elsewhere.
Status write_exr(const fs::path& path, const render::Sensor& sensor, const scene::Development&,
                 const io::Metadata& metadata) {
  io::Metadata told = metadata;
  told.emplace_back("content", "linear sRGB, unclipped, without exposure and white balance");
  return io::write_exr(path, render::develop_linear(sensor), told);
}

constexpr PictureKind kinds[] = {
    {".png", "8-bit sRGB", write_png},
    {".exr", "linear sRGB, unclipped", write_exr},
};

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path one = fs::weakly_canonical(fs::absolute(a), error);
  const fs::path other = fs::weakly_canonical(fs::absolute(b), error);
  return !error && one == other;
}

Status refuse(const std::string& message) { return fail(Failure::usage, message); }

}  // namespace

std::span<const PictureKind> picture_kinds() { return kinds; }

Result<std::vector<PictureFile>> picture_files(const std::vector<std::string>& names) {
  std::vector<PictureFile> files;
  for (const std::string& name : names) {
    const fs::path path(name);
    const PictureKind* found = nullptr;
    for (const PictureKind& kind : kinds)
      if (same_name(path.extension().string(), kind.ending)) found = &kind;
    if (found == nullptr)
      return fail(Failure::usage,
                  fmt::format("--output: expected a file ending in .png or .exr, got '{}'", printable(name)));
    files.push_back({path, found});
  }
  return files;
}

Status check_outputs(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const fs::path& other : outputs.first(i))
      if (same_file(outputs[i], other))
        return refuse(fmt::format("'{}' is given twice as output", outputs[i].string()));
    for (const fs::path& input : inputs)
      if (same_file(outputs[i], input))
        return refuse(fmt::format("'{}' is an input; it is not overwritten", outputs[i].string()));
  }
  Diagnostics errors;
  for (const fs::path& output : outputs) {
    const Status writable = io::check_writable(output);
    if (!writable) errors.insert(errors.end(), writable.errors().begin(), writable.errors().end());
  }
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace shabon::app
