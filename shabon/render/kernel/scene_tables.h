// What the kernel needs of a scene, per wavelength comb: made once before the first pass.
#pragma once

#include <optional>
#include <vector>

#include "shabon/geometry/sphere_set.h"
#include "shabon/optics/packet/free_film.h"
#include "shabon/optics/packet/stack_table.h"
#include "shabon/render/kernel/lanes.h"
#include "shabon/scene/scene.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// How a film's amplitudes are computed.
enum class FilmKind {
  constant,    // lossless, no index depends on the wavelength
  dispersive,  // lossless
  stack,       // any other: several layers, absorption, an index below the medium's
  general,     // the same of one layer, for the models other than airy
  grey,        // constant reflectance, for benchmarks only
};

struct FilmTable {
  FilmKind kind = FilmKind::constant;
  bool lossless = true;
  const film::ThicknessField* thickness = nullptr;
  const scene::NumberTexture* thickness_map_nm = nullptr;  // in place of it, off Scene::spheres
  double n_squared = 1;                                       // constant
  optics::FreeFilmIndices<float> indices{};                   // constant
  std::vector<LanesD> n_squared_lanes;                        // dispersive, per comb
  std::vector<optics::FreeFilmIndices<Lanes>> indices_lanes;  // dispersive, per comb
  std::optional<optics::StackTable> stack;                    // all combs, one after the other
  std::size_t varied_layer = 0;                               // stack
  std::vector<std::array<LanesD, 2>> n_lanes;                 // general, per comb: n and k
};

struct CombTable {
  LanesD inverse_wavelength_per_nm;
  LanesD medium_n_squared;
  Lanes weight[3], plain_weight[3];  // observer, as in Comb
};

struct SphereTable {
  std::vector<double> x, y, z, inverse_radius;
};

struct SceneTables {
  // `combs`: wavelengths other than those of a picture.
  SceneTables(const scene::Scene& scene, std::optional<double> grey_reflectance,
              const std::optional<std::vector<Comb>>& combs = {});

  const scene::Scene& scene;
  geometry::SphereSet spheres;
  SphereTable sphere_table;
  bool lone_sphere = false;     // there is no other
  double medium_n_squared = 1;  // where the medium is constant
  std::vector<FilmTable> films;
  std::vector<CombTable> combs;
  int channel_count = 0;
  std::vector<Lanes> channels;                    // [comb * channel_count + channel]
  std::vector<std::array<float, 3>> channel_xyz;  // the exact colour of a channel seen directly
  float grey_reflectance = 0;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
