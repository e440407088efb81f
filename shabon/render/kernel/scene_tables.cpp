#include "shabon/render/kernel/scene_tables.h"

#include "shabon/color/xyz.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

std::vector<geometry::SphereShape> shapes(const scene::Scene& scene) {
  std::vector<geometry::SphereShape> result;
  for (const scene::Sphere& sphere : scene.spheres) result.push_back({sphere.center, sphere.radius});
  return result;
}

template <class Function>
LanesD per_wavelength(const Comb& comb, const Function& function) {
  double values[lane_count];
  for (int i = 0; i < lane_count; ++i) values[i] = function(comb.wavelength_nm[i]);
  return LanesD::load(values);
}

// A lossless film whose index is nowhere below the medium's has a real angle at every incidence.
bool has_real_angles(const optics::Medium& film, const optics::Medium& outside) {
  if (!film.is_lossless()) return false;
  for (int nm = color::first_nm; nm < color::first_nm + color::spectrum_size; ++nm)
    if (film.index(nm).real() < outside.index(nm).real()) return false;
  return true;
}

optics::StackTable stack_table(const scene::Film& film, const optics::Medium& outside, const std::vector<Comb>& combs) {
  std::vector<double> wavelengths_nm;
  for (const Comb& comb : combs)
    wavelengths_nm.insert(wavelengths_nm.end(), comb.wavelength_nm.begin(), comb.wavelength_nm.end());
  return {optics::Stack{outside, film.layers, outside}, wavelengths_nm};
}

FilmTable film_table(const scene::Film& film, const optics::Medium& outside, optics::Interference interference,
                     const std::vector<Comb>& combs) {
  FilmTable table;
  table.thickness = &film.thickness;
  if (film.thickness_map_nm) table.thickness_map_nm = &*film.thickness_map_nm;
  const optics::Medium& medium = film.layers.front().medium;
  const bool one_real_layer = film.layers.size() == 1 && has_real_angles(medium, outside);
  if (!one_real_layer && interference == optics::Interference::airy) {
    table.kind = FilmKind::stack;
    table.stack = stack_table(film, outside, combs);
    table.lossless = table.stack->lossless;
    table.varied_layer = film.varied_layer;
  } else if (!one_real_layer) {
    table.kind = FilmKind::general;
    table.lossless = medium.is_lossless();
    for (const Comb& comb : combs)
      table.n_lanes.push_back({per_wavelength(comb, [&](double nm) { return medium.index(nm).real(); }),
                               per_wavelength(comb, [&](double nm) { return medium.index(nm).imag(); })});
  } else if (!medium.is_constant() || !outside.is_constant()) {
    table.kind = FilmKind::dispersive;
    for (const Comb& comb : combs) {
      table.n_squared_lanes.push_back(per_wavelength(comb, [&](double nm) { return std::norm(medium.index(nm)); }));
      table.indices_lanes.push_back(optics::free_film_indices(
          per_wavelength(comb, [&](double nm) { return std::norm(outside.index(nm)); }), table.n_squared_lanes.back()));
    }
  } else {
    table.n_squared = std::norm(medium.index(color::first_nm));
    table.indices = optics::free_film_indices(std::norm(outside.index(color::first_nm)), table.n_squared);
  }
  return table;
}

}  // namespace

SceneTables::SceneTables(const scene::Scene& of, std::optional<double> grey,
                         const std::optional<std::vector<Comb>>& chosen)
    : scene(of),
      spheres(shapes(of)),
      lone_sphere(of.spheres.size() == 1),
      channel_count(static_cast<int>(of.environment.channels.size())) {
  for (const scene::Sphere& sphere : of.spheres) {
    sphere_table.x.push_back(sphere.center.x), sphere_table.y.push_back(sphere.center.y);
    sphere_table.z.push_back(sphere.center.z), sphere_table.inverse_radius.push_back(1 / sphere.radius);
  }
  const color::Observer& observer = color::observer_1931();
  const std::vector<Comb> wavelengths = chosen ? *chosen : wavelength_combs(observer, scene.environment.channels);
  medium_n_squared = std::norm(scene.medium.index(color::first_nm));
  for (const Comb& comb : wavelengths) {
    CombTable table;
    table.inverse_wavelength_per_nm = LanesD(1.0) / LanesD::load(comb.wavelength_nm.data());
    table.medium_n_squared = per_wavelength(comb, [&](double nm) { return std::norm(scene.medium.index(nm)); });
    for (std::size_t c = 0; c < 3; ++c) {
      table.weight[c] = math::convert<float>(LanesD::load(comb.weight[c].data()));
      table.plain_weight[c] = math::convert<float>(LanesD::load(comb.plain_weight[c].data()));
    }
    combs.push_back(table);
    for (const color::Spectrum& channel : scene.environment.channels)
      channels.push_back(
          math::convert<float>(per_wavelength(comb, [&](double nm) { return at_wavelength(channel, nm); })));
  }
  for (const color::Spectrum& channel : scene.environment.channels) {
    const color::Xyz xyz = color::radiance_to_xyz(channel, observer);
    channel_xyz.push_back({static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z)});
  }
  for (const scene::Film& film : scene.films)
    films.push_back(film_table(film, scene.medium, scene.render.interference, wavelengths));
  if (grey) {
    grey_reflectance = static_cast<float>(*grey);
    for (FilmTable& film : films) film.kind = FilmKind::grey, film.lossless = true;
  }
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
