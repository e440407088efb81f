#include "shabon/scene/compile_surfaces.h"

#include "shabon/color/rgb_basis.h"
#include "shabon/scene/film_parts.h"

namespace shabon::scene {

bool is_transparent(const optics::Medium& medium) {
  constexpr int step_nm = 5;
  for (int nm = color::first_nm; nm <= color::last_nm; nm += step_nm)
    if (medium.index(nm).imag() >= transparent_extinction) return false;
  return true;
}

std::optional<int> SurfaceCompiler::add(const SurfaceDesc& surface, const Path& path) {
  if (depth_ == 0) parts_ = 0;
  if (!std::holds_alternative<MixSurfaceDesc>(surface.chosen) && ++parts_ > most_parts) {
    if (parts_ == most_parts + 1)
      problems_.add(path, "expected at most " + std::to_string(most_parts) + " surfaces and masks within one surface");
    return {};
  }
  ++depth_;
  const std::optional<Surface> compiled = std::visit(
      [&](const auto& chosen) -> std::optional<Surface> {
        const Path below{&path, about(Of<std::decay_t<decltype(chosen)>>{}).name};
        return compile(chosen, below, *this);
      },
      surface.chosen);
  --depth_;
  if (!compiled) return {};
  scene_.surfaces.push_back(*compiled);
  return static_cast<int>(scene_.surfaces.size()) - 1;
}

std::optional<Film> SurfaceCompiler::film(const FilmDesc& film, const Path& path) {
  const auto parts =
      std::visit([&](const auto& chosen) { return film_parts(chosen, path, resources_.medium, problems_); }, film);
  if (!parts) return {};
  const Path stack{&path, "stack"};
  check_outer_media(parts->outside, parts->inside, stack, problems_);
  check_model(*parts, scene_.render.interference, path, problems_);
  media_.fills_space(parts->outside, stack);
  media_.warn_outside_range(parts->outside, path);
  for (const optics::Layer& layer : parts->layers) media_.warn_outside_range(layer.medium, path);
  Film result{parts->layers, parts->varied_layer, {}, {}};
  const Path vary{&path, "vary"};
  const Path thickness{std::holds_alternative<StackFilmDesc>(film) ? &vary : &path, "thickness"};
  if (const auto* flow = std::get_if<FlowThicknessDesc>(&parts->thickness)) {
    result.thickness = film::ConstantThickness{flow->mean_thickness_nm};  // until it runs
    result.flow = std::make_shared<const film::FlowDesc>(*flow);
    return result;
  }
  const auto found = thickness_nm(parts->thickness, thickness);
  if (const auto* field = std::get_if<film::ThicknessField>(&found))
    result.thickness = *field;
  else
    result.thickness_map_nm = std::get<NumberTexture>(found);
  return result;
}

std::variant<film::ThicknessField, NumberTexture> SurfaceCompiler::thickness_nm(const ThicknessDesc& thickness,
                                                                                const Path& path) {
  if (const auto model = thickness_model(thickness)) return film::at_time(*model, scene_.time_s);
  const Path map{&path, about(Of<ThicknessMapDesc>{}).name};
  const auto picture = textures_.thickness_nm(std::get<ThicknessMapDesc>(thickness), scene_.time_s, map);
  if (const auto* by_place = std::get_if<TexturePicture>(&picture)) return NumberTexture{0, *by_place};
  const auto& cube = std::get<std::shared_ptr<const film::SphereMap>>(picture);
  return cube != nullptr ? film::ThicknessField(cube) : film::ThicknessField();
}

int SurfaceCompiler::add_film(Film film) {
  scene_.films.push_back(std::move(film));
  return static_cast<int>(scene_.films.size()) - 1;
}

std::optional<optics::Stack> SurfaceCompiler::stack(const std::string& text, const Path& path) {
  auto stack = stack_at(Path{&path, "stack"}, text, resources_.medium, problems_);
  if (!stack) return {};
  media_.warn_outside_range(stack->incidence, path);
  for (const optics::Layer& layer : stack->layers) media_.warn_outside_range(layer.medium, path);
  media_.warn_outside_range(stack->exit, path);
  return stack;
}

std::optional<Coating> SurfaceCompiler::coating(const CoatingDesc& coating, const Path& path) {
  const Path place{&path, "stack"}, vary{&path, "vary"};
  const auto found = stack(coating.stack, path);
  if (!found || !check_coherent(found->layers, place, problems_)) return {};
  Coating result{*found, {}};
  if (!is_transparent(found->incidence))
    problems_.add(place,
                  "expected a transparent medium in front, got '" + found->incidence.name() + "', which absorbs");
  const optics::Interference model = interference();
  if (model != optics::Interference::airy && !found->layers.empty())
    problems_.add(place, "expected no coherent layers under 'interference: " + std::string(optics::name_of(model)) +
                             "', which knows free films only; 'interference: airy' takes any number");
  media_.in_front(found->incidence, place);
  if (!coating.vary) return result;
  if (!check_varied(*coating.vary, found->layers.size(), vary, problems_)) return {};
  result.varied.emplace().layer = static_cast<std::size_t>(coating.vary->layer - 1);
  const Path thickness{&vary, "thickness"};
  if (std::holds_alternative<FlowThicknessDesc>(coating.vary->thickness)) {
    problems_.add(thickness, simulated_elsewhere);
    return {};
  }
  result.varied->thickness_nm = thickness_nm(coating.vary->thickness, thickness);
  return result;
}

NumberTexture SurfaceCompiler::number(double constant, const std::optional<NumberMapDesc>& map, const Path& path,
                                      std::string_view map_key) {
  if (!map) return {constant, {}};
  return {constant, textures_.numbers(*map, Path{&path, map_key})};
}

ReflectanceTexture SurfaceCompiler::color(const BaseColorDesc& base, const Path& path) {
  if (base.color_map) return {picture_basis(), textures_.colors(*base.color_map, Path{&path, "color_map"})};
  const Path place{&path, "color"};
  if (const auto* number = std::get_if<double>(&base.color.value)) return {reflectance({*number, *number, *number})};
  if (const auto* rgb = std::get_if<math::Vec3d>(&base.color.value)) return {reflectance({rgb->x, rgb->y, rgb->z})};
  const auto& text = std::get<std::string>(base.color.value);
  if (const auto rgb = hex_color(text)) return {reflectance(*rgb)};
  if (const auto file = color_file(text)) return {reflectance_file(*file, place)};
  return {};  // told by check_value()
}

int SurfaceCompiler::reflectance(const color::LinearRgb& rgb) {
  const auto [entry, added] =
      reflectance_of_.try_emplace({rgb.r, rgb.g, rgb.b}, static_cast<int>(scene_.reflectances.size()));
  if (added) scene_.reflectances.push_back(color::rgb_to_reflectance(rgb));
  return entry->second;
}

int SurfaceCompiler::reflectance_file(const std::string& file, const Path& place) {
  if (problems_.has(place)) return 0;
  const auto known = reflectance_of_file_.find(file);
  if (known != reflectance_of_file_.end()) return known->second;
  const Result<color::Spectrum> spectrum = resources_.reflectance(file);
  if (!spectrum) {
    for (const Diagnostic& error : spectrum.errors()) problems_.add_from_file(place, error);
    return 0;
  }
  scene_.reflectances.push_back(*spectrum);
  return reflectance_of_file_[file] = static_cast<int>(scene_.reflectances.size()) - 1;
}

int SurfaceCompiler::picture_basis() {
  if (!picture_basis_) {
    picture_basis_ = static_cast<int>(scene_.reflectances.size());
    const color::RgbBasis& basis = color::rgb_basis();
    for (const color::Spectrum& channel : {basis.r, basis.g, basis.b}) scene_.reflectances.push_back(channel);
  }
  return *picture_basis_;
}

void check_beside_map(bool number_given, bool map_given, std::string_view key, std::string_view map_key,
                      const Path& path, Problems& problems) {
  if (number_given && map_given)
    problems.add_warning(Path{&path, key}, "does not count beside '" + std::string(map_key) + "'");
}

void check_roughness(const RoughnessDesc& roughness, const Path& path, Problems& problems) {
  check_beside_map(roughness.roughness != RoughnessDesc{}.roughness, roughness.roughness_map.has_value(), "roughness",
                   "roughness_map", path, problems);
}

void check_color(const BaseColorDesc& color, const Path& path, Problems& problems) {
  check_beside_map(!(color.color == ColorDesc{}), color.color_map.has_value(), "color", "color_map", path, problems);
}

}  // namespace shabon::scene
