// The pictures of a scene that vary something over surfaces: each file is read once.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <variant>

#include "shabon/film/sphere_map.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/resources.h"
#include "shabon/scene/texture.h"
#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

// What cannot be read or has values out of range becomes a problem, and a texture without a picture.
class Textures {
 public:
  Textures(const Resources& resources, Problems& problems) : resources_(resources), problems_(problems) {}

  // Numbers 0..1; of colours the mean of red, green and blue as they stand in the file.
  TexturePicture numbers(const NumberMapDesc& map, const Path& path);
  // Nanometres, at a moment. Whole numbers need low_nm and high_nm. A cube becomes a map of all directions; both kinds
  // are null when something is wrong.
  std::variant<TexturePicture, std::shared_ptr<const film::SphereMap>> thickness_nm(const ThicknessMapDesc& map,
                                                                                    double time_s, const Path& path);
  // Linear sRGB, 0..1 in three channels; what is above becomes 1, with a warning.
  TexturePicture colors(const ColorMapDesc& map, const Path& path);

 private:
  using Raster = std::shared_ptr<const math::Raster>;

  const TextureFile* file(const std::string& name, const Path& map);
  Raster frame_nm(const std::string& file, const ThicknessMapDesc& map, const Path& path);
  Raster scaled(const std::string& file, double low, double high, const FieldInfo& allowed, const Path& map);
  void warn_of_layout(const math::Raster& picture, const std::string& file, const Path& path);
  void warn_of_units(const ThicknessMapDesc& map, const math::Raster& picture, const Path& path);
  Raster linear_rgb(const TextureFile& texture, const Path& map);

  const Resources& resources_;
  Problems& problems_;
  std::map<std::string, Result<TextureFile>> files_;
  std::map<std::tuple<std::string, double, double>, Raster> numbers_;
  std::map<std::string, Raster> colors_;
  std::map<Raster, std::shared_ptr<const film::SphereMap>> cubes_;
};

}  // namespace shabon::scene
