// Each surface of scene/surface.h, as lobes.
#include "shabon/render/kernel/film_optics.h"
#include "shabon/render/kernel/scattering/lobe.h"
#include "shabon/render/microfacet.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

Block none() { return {Lanes(0.0f), Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)}; }
Block unchanged() { return {Lanes(1.0f), Lanes(0.0f), Lanes(1.0f), Lanes(0.0f)}; }

// The blocks of a free film by the bubble kernel's own code, for one event.
Mueller film_blocks(const SceneTables& tables, const FilmTable& film, const Vertex& vertex, double thickness_nm) {
  EventBlock event;
  event.film[0] = &film;
  event.inward[0] = !vertex.from_back;
  event.cos_i[0] = vertex.cos_o;
  event.thickness_nm[0] = thickness_nm;
  const double q1_squared = tables.medium_n_squared * std::max(vertex.cos_o * vertex.cos_o, optics::least_cos2);
  const double q2_squared = film.n_squared - tables.medium_n_squared + q1_squared;
  event.q1_squared[0] = q1_squared, event.q2_squared[0] = q2_squared;
  event.q2[0] = std::sqrt(std::max(0.0, q2_squared));
  if (tables.scene.render.interference != optics::Interference::two_beam)
    return event_mueller(tables, event, 0, vertex.comb);
  const Powers p = event_powers(tables, event, 0, vertex.comb);  // (13): no polarisation is left
  const Lanes half(0.5f), zero(0.0f);
  return {{half * (p.R_s + p.R_p), zero, zero, zero}, {half * (p.T_s + p.T_p), zero, zero, zero}};
}

// Adds the lobes of one surface; `share` is how much of the spot it covers.
struct LobeMaker {
  const ScatteringTables& tables;
  const Vertex& vertex;
  int film_slot;
  Lobes& lobes;
  float share = 1;
  int index = -1;  // Scene::surfaces

  Lobe* add(LobeKind kind) const {
    if (share <= 0) return nullptr;
    Lobe* lobe = lobes.add();
    if (lobe == nullptr) return nullptr;
    *lobe = Lobe();
    lobe->kind = kind, lobe->block = none(), lobe->share = share;
    return lobe;
  }

  void add_films(int first_film, int film_count) const {
    const int slot = film_slot >= 0 ? film_slot : vertex.from_back ? film_count - 1 : 0;
    const FilmTable& film = tables.films.films[static_cast<std::size_t>(first_film + slot)];
    const double thickness_nm = film.thickness_map_nm != nullptr
                                    ? film.thickness_map_nm->at(vertex.at.u, vertex.at.v)
                                    : film::thickness_nm(*film.thickness, vertex.at.from_centre);
    const Mueller m = film_blocks(tables.films, film, vertex, thickness_nm);
    const auto next = [&](int step) {
      const int to = slot + (vertex.from_back ? -step : step);
      return static_cast<std::int16_t>(to >= 0 && to < film_count ? to : -1);
    };
    if (Lobe* lobe = add(LobeKind::mirror)) lobe->block = m.reflected, lobe->film_slot = next(-1);
    if (Lobe* lobe = add(LobeKind::straight)) lobe->block = m.transmitted, lobe->film_slot = next(1);
  }

  CoatingHere coating_here() const {
    const CoatingTable& table = *tables.surfaces[static_cast<std::size_t>(index)].coating;
    CoatingHere here{&table, vertex.from_back && !table.opaque, -1};
    if (const auto& varied = table.coating->varied)
      here.thickness_nm = std::visit(
          [&](const auto& thickness) {
            if constexpr (std::is_same_v<std::decay_t<decltype(thickness)>, scene::NumberTexture>)
              return thickness.at(vertex.at.u, vertex.at.v);
            else
              return film::thickness_nm(thickness, vertex.at.from_centre);
          },
          varied->thickness_nm);
    return here;
  }

  float alpha_of(const scene::NumberTexture& roughness) const {
    return static_cast<float>(std::clamp(roughness.at(vertex.at.u, vertex.at.v), 0.0, 1.0));
  }

  Lanes reflectance(const scene::ReflectanceTexture& texture) const {
    float coefficients[3] = {};
    texture.coefficients(vertex.at.u, vertex.at.v, coefficients);
    const Lanes* row =
        &tables.reflectances[vertex.comb * tables.reflectance_count + static_cast<std::size_t>(texture.first_channel)];
    Lanes sum = row[0] * coefficients[0];
    for (int k = 1; k < texture.channel_count(); ++k) sum += row[k] * coefficients[k];
    return sum;
  }

  // The boundary's reflection, smooth or rough.
  Lobe* add_reflection(const CoatingHere& coating, float alpha, const Block& block) const {
    Lobe* lobe = add(alpha >= least_alpha ? LobeKind::rough_mirror : LobeKind::mirror);
    if (lobe != nullptr) lobe->block = block, lobe->alpha = alpha, lobe->coating = coating;
    return lobe;
  }

  void operator()(const scene::FreeFilmSurface& surface) const { add_films(surface.first_film, surface.film_count); }

  void add_facets(const CoatingHere& coating, float alpha, bool parts_wavelengths) const {
    const std::size_t comb = vertex.comb;
    const Lanes n_squared = coating.table->n_behind_squared[comb], one(1.0f);
    const Lanes near = coating.from_back ? n_squared : one, far = coating.from_back ? one : n_squared;
    const Lanes near_mean = coating.mean_rest(comb, alpha), far_mean = coating.mean_rest(comb, alpha, true);
    const Lanes rest = coating.rest(comb, vertex.cos_o, alpha);
    const Lanes all = rest / max(near * near_mean + far * far_mean, Lanes(1e-20f));  // (62)
    const RestTable::Once once = coating.rest_table(false).once(vertex.cos_o, alpha, coating.thickness_nm);
    const auto add_one = [&](LobeKind kind, float sharp, const Lanes& n2, const Lanes& rest_mean) {
      Lobe* lobe = add(kind);
      if (lobe == nullptr) return;
      lobe->alpha = alpha, lobe->coating = coating;
      lobe->albedo = all * n2;
      const Lanes lost = lobe->albedo * rest_mean;
      lobe->block.a = Lanes(sharp) + lost;
      lobe->lost = mean(lost) / std::max(1e-20f, sharp + mean(lost));
      lobe->parts_wavelengths = parts_wavelengths && kind == LobeKind::rough_refracted;
    };
    add_one(LobeKind::rough_mirror, once.mirrored, near, near_mean);
    add_one(LobeKind::rough_refracted, once.refracted, far, far_mean);
  }

  void operator()(const scene::DielectricSurface& surface) const {
    const CoatingHere coating = coating_here();
    const float alpha = alpha_of(surface.roughness);
    const bool rough = alpha >= least_alpha, bends = coating.table->bends();
    const bool parts = !coating.table->one_direction && !vertex.one_lane;
    if (rough && bends) return add_facets(coating, alpha, parts);
    const auto m = coating.at(vertex.comb, vertex.cos_o);
    add_reflection(coating, alpha, m.reflected);
    Lobe* lobe = add(bends ? LobeKind::refracted : LobeKind::straight);
    if (lobe == nullptr) return;
    lobe->block = m.transmitted, lobe->coating = coating, lobe->parts_wavelengths = parts;
    if (!rough) return;
    // Straight on goes all that is not mirrored, the same from both sides.
    const Lanes front = coating.rest(vertex.comb, vertex.cos_o, alpha);
    const Lanes back = coating.rest(vertex.comb, vertex.cos_o, alpha, true);
    lobe->block = scaled(lobe->block, Lanes(0.5f) * (front + back) / max(lobe->block.a, Lanes(1e-20f)));
  }

  void operator()(const scene::ConductorSurface& surface) const {
    const CoatingHere coating = coating_here();
    const float alpha = alpha_of(surface.roughness);
    Lobe* lobe = add_reflection(coating, alpha, coating.at(vertex.comb, vertex.cos_o).reflected);
    if (lobe == nullptr || alpha < least_alpha) return;
    lobe->lost = static_cast<float>(1 - single_scattering(vertex.cos_o, alpha));
    const auto once = static_cast<float>(mean_single_scattering(alpha));
    const Lanes R = coating.diffuse_means(vertex.comb).reflected;  // (56)
    lobe->albedo = R * R * Lanes(once * lobe->lost / (1 - once)) / (Lanes(1.0f) - R * Lanes(1 - once));
  }

  void operator()(const scene::GlossySurface& surface) const {
    CoatingHere coating = coating_here();
    coating.from_back = false;
    const float alpha = alpha_of(surface.roughness);
    add_reflection(coating, alpha, coating.at(vertex.comb, vertex.cos_o).reflected);
    Lobe* lobe = add(LobeKind::embedded);
    if (lobe == nullptr) return;
    lobe->block = coating.entering(vertex.comb, vertex.cos_o, alpha), lobe->alpha = alpha, lobe->coating = coating;
    const Lanes rho = reflectance(surface.base), n_squared = coating.table->n_behind_squared[vertex.comb];
    const Lanes entering =
        alpha < least_alpha ? coating.diffuse_means(vertex.comb).transmitted : coating.mean_rest(vertex.comb, alpha);
    lobe->albedo = rho / (n_squared * (Lanes(1.0f) - rho * (Lanes(1.0f) - entering / n_squared)));
  }

  void operator()(const scene::PaneSurface&) const {
    const PaneTable& pane = *tables.surfaces[static_cast<std::size_t>(index)].pane;
    const auto m = pane.at(vertex.comb, vertex.cos_o, vertex.from_back);
    if (Lobe* lobe = add(LobeKind::mirror)) lobe->block = m.reflected;
    if (Lobe* lobe = add(LobeKind::straight)) lobe->block = m.transmitted;
  }

  void operator()(const scene::DiffuseSurface& surface) const {
    if (Lobe* lobe = add(LobeKind::diffuse)) lobe->albedo = reflectance(surface.color);
  }

  void operator()(const scene::EmitterSurface& surface) const {
    if (vertex.from_back && !surface.both_sides) return;
    const std::size_t row = vertex.comb * static_cast<std::size_t>(tables.films.channel_count);
    lobes.emitted += tables.films.channels[row + static_cast<std::size_t>(surface.channel)] *
                     Lanes(share * static_cast<float>(surface.scale));
    lobes.emits = true;
  }

  void operator()(const scene::MixSurface& surface) const {
    const auto second = static_cast<float>(std::clamp(surface.amount.at(vertex.at.u, vertex.at.v), 0.0, 1.0));
    part(surface.first, share * (1 - second));
    part(surface.second, share * second);
  }

  void operator()(const scene::MaskSurface& surface) const {
    const auto covered = static_cast<float>(std::clamp(surface.opacity.at(vertex.at.u, vertex.at.v), 0.0, 1.0));
    part(surface.surface, share * covered);
    LobeMaker rest = *this;
    rest.share = share * (1 - covered);
    if (Lobe* lobe = rest.add(LobeKind::straight)) lobe->block = unchanged();
  }

  void part(int surface, float covered) const {
    if (covered <= 0) return;
    LobeMaker maker = *this;
    maker.share = covered, maker.index = surface;
    std::visit(maker, tables.scene.surfaces[static_cast<std::size_t>(surface)]);
  }
};

}  // namespace

void lobes_of(const ScatteringTables& tables, const Vertex& vertex, int shape, int film_slot, Lobes& lobes) {
  const ShapeTable& met = tables.shape[static_cast<std::size_t>(shape)];
  lobes.count = 0, lobes.emits = false, lobes.emitted = Lanes(0.0f);
  LobeMaker maker{tables, vertex, film_slot, lobes};
  if (met.surface < 0)
    maker.add_films(met.first_film, met.film_count);
  else
    maker.part(met.surface, 1);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
