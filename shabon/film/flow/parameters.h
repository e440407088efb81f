// What a simulated film is: plain data with defaults, keys, units and ranges. docs/living-film.md says what each does.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/base/result.h"
#include "shabon/film/flow/air.h"
#include "shabon/film/flow/sources.h"
#include "shabon/film/liquid.h"
#include "shabon/math/vec.h"

namespace shabon::film {

// The film at the beginning; its mean thickness is that of FlowDesc.
struct InitialFilmDesc {
  bool equilibrium = false;
  double slope = 0;
  double noise = 0.25;
  double noise_scale_m = 0.01;
  double swirl_m_s = 0;
  double swirl_scale_m = 0.02;
};

constexpr auto fields(Of<InitialFilmDesc>) {
  constexpr Range scale_m{.low = 1e-3, .high = 1};
  return std::tuple{
      Field{"equilibrium",
            &InitialFilmDesc::equilibrium,
            {.doc = "in balance with gravity, (79), instead of uniform; with `slope` the surfactant alone, (95)"}},
      Field{"slope",
            &InitialFilmDesc::slope,
            {.range = {.low = 0, .high = 0.99},
             .doc = "straight in height: the lowest point thicker, the highest thinner than the mean by this share"}},
      Field{"noise",
            &InitialFilmDesc::noise,
            {.range = {.low = 0, .high = 0.9}, .doc = "root mean square of the thickness's relative noise"}},
      Field{"noise_scale_m",
            &InitialFilmDesc::noise_scale_m,
            {.unit = "m", .range = scale_m, .doc = "size of the noise: half its shortest wavelength"}},
      Field{"swirl_m_s",
            &InitialFilmDesc::swirl_m_s,
            {.unit = "m/s", .range = {.low = 0, .high = 5}, .doc = "root mean square speed of eddies in the film"}},
      Field{"swirl_scale_m",
            &InitialFilmDesc::swirl_scale_m,
            {.unit = "m", .range = scale_m, .doc = "size of these eddies: half their shortest wavelength"}}};
}

struct FlowStepDesc {
  double courant = 0.6;
  double longest_s = 8e-3;
  double shortest_s = 1e-7;
  double tolerance = 1e-5;
  int most_iterations = 2000;
};

constexpr auto fields(Of<FlowStepDesc>) {
  return std::tuple{
      Field{"courant",
            &FlowStepDesc::courant,
            {.range = {.low = 0.01, .high = 0.72},
             .doc = "most cells that the film crosses in one step; steps aim at 1/1.2 of it"}},
      Field{"longest_s",
            &FlowStepDesc::longest_s,
            {.unit = "s", .range = {.low = 1e-6, .high = 0.1}, .doc = "longest step"}},
      Field{"shortest_s",
            &FlowStepDesc::shortest_s,
            {.unit = "s", .range = {.low = 1e-12, .high = 1e-3}, .doc = "the run stops when steps had to be shorter"}},
      Field{
          "tolerance",
          &FlowStepDesc::tolerance,
          {.range = {.low = 1e-12, .high = 1e-2}, .doc = "residual of the Marangoni step, relative to the surfactant"}},
      Field{"most_iterations",
            &FlowStepDesc::most_iterations,
            {.range = {.low = 1, .high = 100000},
             .doc = "the run stops when the Marangoni step takes more, in shorter steps too"}}};
}

inline constexpr int finest_flow_level = 8;

struct FlowDesc {
  int level = 5;  // 10 4^level + 2 cells
  std::uint64_t seed = 1;
  double radius_m = 0.03;
  double mean_thickness_nm = 800;
  double density_kg_m3 = 1000;
  double viscosity_pa_s = 1e-3;
  double surface_viscosity_kg_s = 5e-9;
  double elasticity_n_m = 22e-3;
  double air_drag_kg_m2_s = 0.023;
  math::Vec3d gravity_m_s2{0, -standard_gravity_m_s2, 0};
  InitialFilmDesc initial = {};
  std::vector<AirMotion> air = {};
  std::optional<EvaporationDesc> evaporation = {};
  std::optional<RegenerationDesc> regeneration = {};
  std::optional<BlackFilmDesc> black_film = {};
  std::optional<RuptureDesc> rupture = {};
  FlowStepDesc step = {};
};

constexpr auto fields(Of<FlowDesc>) {
  return std::tuple{
      Field{"level",
            &FlowDesc::level,
            {.range = {.low = 1, .high = finest_flow_level}, .doc = "fineness of the grid: 10 4^level + 2 cells"}},
      Field{"seed", &FlowDesc::seed, {.doc = "of everything random in the film"}},
      Field{"radius_m",
            &FlowDesc::radius_m,
            {.unit = "m", .range = {.low = 0.005, .high = 0.15}, .doc = "radius of the bubble"}},
      Field{"mean_thickness_nm",
            &FlowDesc::mean_thickness_nm,
            {.unit = "nm", .range = {.low = 50, .high = 5000}, .doc = "mean over the sphere at the beginning"}},
      Field{"density_kg_m3",
            &FlowDesc::density_kg_m3,
            {.unit = "kg/m^3", .range = {.low = 500, .high = 2000}, .doc = "of the liquid"}},
      Field{"viscosity_pa_s",
            &FlowDesc::viscosity_pa_s,
            {.unit = "Pa s", .range = {.low = 0, .high = 0.2}, .doc = "of the liquid"}},
      Field{"surface_viscosity_kg_s",
            &FlowDesc::surface_viscosity_kg_s,
            {.unit = "kg/s", .range = {.low = 0, .high = 1e-6}, .doc = "of each surface, in shear"}},
      Field{"elasticity_n_m",
            &FlowDesc::elasticity_n_m,
            {.unit = "N/m", .range = {.low = 5e-4, .high = 1}, .doc = "Gibbs elasticity of the film, both surfaces"}},
      Field{"air_drag_kg_m2_s",
            &FlowDesc::air_drag_kg_m2_s,
            {.unit = "kg/(m^2 s)",
             .range = {.low = 0, .high = 1},
             .doc = "drag of the air per area and speed, both sides"}},
      Field{"gravity_m_s2",
            &FlowDesc::gravity_m_s2,
            {.unit = "m/s^2", .range = {.low = -100, .high = 100}, .doc = "acceleration of gravity"}},
      Field{"initial", &FlowDesc::initial, {.doc = "the film at the beginning"}},
      Field{"air", &FlowDesc::air, {.doc = "what moves the air; empty is air at rest"}},
      Field{"evaporation", &FlowDesc::evaporation, {.doc = "liquid lost to the air"}},
      Field{"regeneration", &FlowDesc::regeneration, {.doc = "thin patches from the bottom (marginal regeneration)"}},
      Field{"black_film", &FlowDesc::black_film, {.doc = "collapse of thin film to black film"}},
      Field{"rupture", &FlowDesc::rupture, {.doc = "the thickness at which the film breaks"}},
      Field{"step", &FlowDesc::step, {.doc = "time step and solver"}}};
}

// Every range above and what must fit together, as errors with keys ("elasticity_n_m"). Empty when all is well.
Diagnostics check(const FlowDesc& desc);

}  // namespace shabon::film
