#include "other_scene.h"

#include <memory>
#include <tuple>
#include <variant>

namespace shabon::test {

namespace {

std::shared_ptr<const film::SphereMap> scaled(const std::shared_ptr<const film::SphereMap>& map, double factor) {
  film::SphereMap result = *map;
  for (float& nm : result.nm) nm *= static_cast<float>(factor);
  return std::make_shared<const film::SphereMap>(std::move(result));
}

film::LatitudeMap scaled(film::LatitudeMap map, double factor) {
  math::Raster result = *map.nm;
  for (float& nm : result.values) nm *= static_cast<float>(factor);
  map.nm = std::make_shared<const math::Raster>(std::move(result));
  return map;
}

film::ExponentialThickness scaled(film::ExponentialThickness film, double factor) {
  film.middle_nm *= factor;
  return film;
}

film::DrainedThickness scaled(film::DrainedThickness film, double factor) {
  film.start_nm *= factor, film.nm_at_half_height *= factor;
  if (film.nm == nullptr) return film;
  std::vector<double> result = *film.nm;
  for (double& nm : result) nm *= factor;
  film.nm = std::make_shared<const std::vector<double>>(std::move(result));
  return film;
}

void scale(film::ThicknessField& thickness, double factor);

film::NoiseField scaled(film::NoiseField film, double factor) {
  scale(film.base->field, factor);
  return film;
}

film::HoledFilm scaled(film::HoledFilm holed, double factor) {
  scale(holed.film->field, factor);
  return holed;
}

void scale(scene::NumberTexture& texture, double factor) {
  texture.constant *= factor;
  if (texture.picture.raster == nullptr) return;
  math::Raster scaled = *texture.picture.raster;
  for (float& value : scaled.values) value *= static_cast<float>(factor);
  texture.picture.raster = std::make_shared<const math::Raster>(std::move(scaled));
}

void scale(film::ThicknessField& thickness, double factor) {
  std::visit(
      [factor]<class Field>(Field& chosen) {
        if constexpr (requires { fields(Of<Field>{}); }) {  // a model as it stands: its members in nanometres
          const auto scale_field = [&](const auto& field) {
            if (field.info.unit == "nm") chosen.*field.member *= factor;
          };
          std::apply([&](const auto&... field) { (scale_field(field), ...); }, fields(Of<Field>{}));
        } else {
          chosen = scaled(chosen, factor);
        }
      },
      thickness);
}

int scale(std::vector<optics::Layer>& layers, double factor) {
  int count = 0;
  for (optics::Layer& layer : layers)
    if (layer.coherent) layer.thickness_nm *= factor, ++count;
  return count;
}

}  // namespace

int scale_layers(scene::Scene& scene, double factor) {
  int count = 0;
  for (scene::Film& film : scene.films) {
    count += scale(film.layers, factor);
    scale(film.thickness, factor);
    if (film.thickness_map_nm) scale(*film.thickness_map_nm, factor);
  }
  for (scene::Surface& surface : scene.surfaces)
    std::visit(
        [&](auto& chosen) {
          if constexpr (requires { chosen.coating; }) {
            count += scale(chosen.coating.stack.layers, factor);
            if (chosen.coating.varied)
              std::visit([&](auto& thickness) { scale(thickness, factor); }, chosen.coating.varied->thickness_nm);
          } else if constexpr (requires { chosen.stack; }) {
            count += scale(chosen.stack.layers, factor);
          }
        },
        surface);
  return count;
}

int stop_dispersion(scene::Scene& scene) {
  int count = 0;
  for (scene::Surface& surface : scene.surfaces)
    if (auto* glass = std::get_if<scene::DielectricSurface>(&surface)) {
      optics::Medium& behind = glass->coating.stack.exit;
      if (behind.is_constant()) continue;
      behind = optics::Medium::constant(behind.index(550).real());
      ++count;
    }
  return count;
}

}  // namespace shabon::test
