// Surfaces of a scene file -> Scene::surfaces. Each surface's own compile() stands in surfaces/; here is what they
// share.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "shabon/scene/lamp_channels.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/resources.h"
#include "shabon/scene/scene.h"
#include "shabon/scene/scene_media.h"
#include "shabon/scene/surface.h"
#include "shabon/scene/textures.h"

namespace shabon::scene {

// Whatever is wrong becomes a problem. Paths lead to the mapping that holds the keys in question.
// Why a simulated film is refused off a bubble.
inline constexpr const char* simulated_elsewhere =
    "expected a thickness model or a map, got 'flow': a simulated film is closed, and only a bubble has one";

class SurfaceCompiler {
 public:
  SurfaceCompiler(Scene& scene, LampChannels& lamps, SceneMedia& media, const Resources& resources, Problems& problems)
      : scene_(scene),
        lamps_(lamps),
        media_(media),
        resources_(resources),
        problems_(problems),
        textures_(resources, problems) {}

  // Compiles the surface and those within it; its index in Scene::surfaces.
  std::optional<int> add(const SurfaceDesc& surface, const Path& path);

  // A free film: its two sides are the scene's medium.
  std::optional<Film> film(const FilmDesc& film, const Path& path);
  int add_film(Film film);

  // At the scene's time; `path` leads to it.
  std::variant<film::ThicknessField, NumberTexture> thickness_nm(const ThicknessDesc& thickness, const Path& path);

  // The stack written there; its media are checked against their ranges. Coherent layers only for a coating, whose
  // front medium must be transparent.
  std::optional<optics::Stack> stack(const std::string& text, const Path& path);
  std::optional<Coating> coating(const CoatingDesc& coating, const Path& path);

  // The map, if there is one; else the number.
  NumberTexture number(double constant, const std::optional<NumberMapDesc>& map, const Path& path,
                       std::string_view map_key);
  ReflectanceTexture color(const BaseColorDesc& color, const Path& path);

  int lamp(const LampDesc& lamp, const Path& path) { return lamps_.of(lamp.illuminant, path); }

  SceneMedia& media() { return media_; }
  Problems& problems() { return problems_; }
  optics::Interference interference() const { return scene_.render.interference; }

 private:
  int reflectance(const color::LinearRgb& rgb);
  int reflectance_file(const std::string& file, const Path& place);
  int picture_basis();

  Scene& scene_;
  LampChannels& lamps_;
  SceneMedia& media_;
  const Resources& resources_;
  Problems& problems_;
  Textures textures_;
  int depth_ = 0, parts_ = 0;  // of the surface that is being compiled
  std::map<std::array<double, 3>, int> reflectance_of_;
  std::map<std::string, int> reflectance_of_file_;
  std::optional<int> picture_basis_;
};

// Whether light gets through a visible depth of the medium: its k stays below transparent_extinction at 360..830 nm.
bool is_transparent(const optics::Medium& medium);

// A number that stands beside the map in place of it, and is not the default, is told.
void check_beside_map(bool number_given, bool map_given, std::string_view key, std::string_view map_key,
                      const Path& path, Problems& problems);
void check_roughness(const RoughnessDesc& roughness, const Path& path, Problems& problems);
void check_color(const BaseColorDesc& color, const Path& path, Problems& problems);

}  // namespace shabon::scene
