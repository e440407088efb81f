#include "shabon/film/flow/presets.h"

#include "shabon/base/text.h"

namespace shabon::film {

namespace {

FlowDesc fresh() {
  FlowDesc desc;
  desc.mean_thickness_nm = 1000;
  desc.initial = {.noise = 0.2, .noise_scale_m = 0.008, .swirl_m_s = 0.25, .swirl_scale_m = 0.012};
  desc.air = {AirSwirls{.speed_m_s = 0.15, .scale_m = 0.025, .change_s = 6}};
  desc.evaporation = EvaporationDesc{.rate_nm_s = 20};
  // Eddies alone even the film out within ten seconds: thin patches keep its colours apart.
  desc.regeneration = RegenerationDesc{.ratio = 0.8, .patch_radius_m = 3.5e-3, .rate_per_s = 80};
  return desc;
}

FlowDesc drain() {
  FlowDesc desc;
  desc.mean_thickness_nm = 700;
  desc.initial = {.equilibrium = true, .noise = 0.25, .noise_scale_m = 0.006};
  desc.evaporation = EvaporationDesc{};
  desc.regeneration = RegenerationDesc{};
  return desc;
}

FlowDesc gust() {
  FlowDesc desc;
  desc.radius_m = 0.05;
  desc.mean_thickness_nm = 800;
  desc.initial.noise_scale_m = 0.015;
  desc.air = {AirGusts{.rate_per_s = 2, .speed_m_s = 1.6, .half_width_deg = 30, .length_s = 0.6}};
  desc.evaporation = EvaporationDesc{};
  desc.regeneration = RegenerationDesc{.rate_per_s = 80};
  return desc;
}

FlowDesc old() {
  FlowDesc desc;
  desc.mean_thickness_nm = 130;
  desc.initial = {.equilibrium = true, .noise = 0.35, .noise_scale_m = 0.006};
  desc.air = {AirSwirls{.speed_m_s = 0.03, .scale_m = 0.03}};
  desc.evaporation = EvaporationDesc{.rate_nm_s = 4, .top_excess = 0.3};
  desc.regeneration = RegenerationDesc{.rate_per_s = 20};
  desc.black_film = BlackFilmDesc{};
  return desc;
}

FlowDesc giant() {
  FlowDesc desc;
  desc.radius_m = 0.1;
  desc.mean_thickness_nm = 900;
  desc.initial = {.noise = 0.3, .noise_scale_m = 0.02, .swirl_m_s = 0.1, .swirl_scale_m = 0.04};
  desc.air = {AirSwirls{.speed_m_s = 0.3, .scale_m = 0.06, .change_s = 8}};
  desc.evaporation = EvaporationDesc{};
  desc.regeneration = RegenerationDesc{.patch_radius_m = 5e-3, .rate_per_s = 100};
  return desc;
}

FlowDesc glycerol() {
  FlowDesc desc;
  desc.mean_thickness_nm = 900;
  desc.density_kg_m3 = 1200;
  desc.viscosity_pa_s = 6e-2;
  desc.surface_viscosity_kg_s = 5e-8;
  desc.elasticity_n_m = 15e-3;
  desc.initial = {.noise = 0.3, .noise_scale_m = 0.008};
  desc.air = {AirRotation{.axis = {0.2, 1, 0.1}, .speed_m_s = 0.1}};
  desc.evaporation = EvaporationDesc{.rate_nm_s = 5};
  desc.regeneration = RegenerationDesc{.rate_per_s = 10};
  return desc;
}

// The parameters that Huang et al. 2020 (table 2) give for a bubble of 5 cm: a soft film that gravity squeezes a lot.
FlowDesc huang2020() {
  FlowDesc desc;
  desc.radius_m = 0.05;
  desc.mean_thickness_nm = 1000;
  desc.elasticity_n_m = 0.8e-3;
  desc.initial = {.noise = 0.2, .noise_scale_m = 0.008, .swirl_m_s = 0.1, .swirl_scale_m = 0.02};
  desc.evaporation = EvaporationDesc{.rate_nm_s = 60};
  return desc;
}

// The film of the paper of 1989, 150 nm at the top and 900 at the bottom, that its authors wished to see flow: at rest
// by itself, until the drop below and air so light that the bands survive it stir it. Damp air takes nothing of it.
FlowDesc linear1989() {
  constexpr double top_nm = 150, bottom_nm = 900;
  FlowDesc desc;
  desc.mean_thickness_nm = (top_nm + bottom_nm) / 2;
  desc.initial = {.equilibrium = true, .slope = (bottom_nm - top_nm) / (bottom_nm + top_nm), .noise = 0};
  desc.air = {AirSwirls{.speed_m_s = 0.03, .scale_m = 0.02, .envelope = {.ramp_s = 1}}};
  desc.regeneration = RegenerationDesc{.rate_per_s = 12};
  return desc;
}

}  // namespace

const std::vector<FlowPreset>& flow_presets() {
  static const std::vector<FlowPreset> presets = {
      {"fresh", "Just blown: eddies under 1 um of film.", fresh()},
      {"drain", "Bands sort by thickness, thin plumes rise from the bottom.", drain()},
      {"gust", "Puffs of wind over a film that drains.", gust()},
      {"old", "Some minutes old: silver and black film at the top.", old()},
      {"giant", "A bubble of 20 cm in moving air.", giant()},
      {"glycerol", "A film of glycerol and water: slow and smooth.", glycerol()},
      {"huang2020", "The soft film of Huang et al. 2020, squeezed by gravity.", huang2020()},
      {"linear1989", "The straight film of the paper of 1989, and what becomes of it.", linear1989()},
  };
  return presets;
}

const FlowPreset* flow_preset(std::string_view name) {
  for (const FlowPreset& preset : flow_presets())
    if (same_name(preset.name, name)) return &preset;
  return nullptr;
}

}  // namespace shabon::film
