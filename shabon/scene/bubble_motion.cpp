#include "shabon/scene/bubble_motion.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "shabon/base/text.h"
#include "shabon/math/normal_to.h"
#include "shabon/scene/compile_surfaces.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

constexpr double metres_per_nm = 1e-9;

// The largest sum of amplitudes over the radius: beyond it small oscillations say nothing, and twice as much could turn
// the bubble inside out.
constexpr double largest_tremble = 0.5;

// Of the layer that has a thickness of its own at each place.
std::optional<double> mean_of_varied(const FilmDesc& desc, const Film& film, double time_s) {
  const ThicknessDesc* stated = nullptr;
  if (const auto* medium = std::get_if<MediumFilmDesc>(&desc)) stated = &medium->thickness;
  const auto* stack = std::get_if<StackFilmDesc>(&desc);
  if (stack != nullptr && stack->vary) stated = &stack->vary->thickness;
  if (stated == nullptr) return film.layers[film.varied_layer].thickness_nm;
  if (const auto* flow = std::get_if<FlowThicknessDesc>(stated)) return flow->mean_thickness_nm;
  const auto model = thickness_model(*stated);
  if (!model) return {};
  return film::mean_thickness_nm(film::at_time(*model, time_s));
}

std::optional<double> mean_thickness_nm(const BubbleDesc& bubble, const Film& film, double time_s) {
  if (bubble.body.thickness_nm) return bubble.body.thickness_nm;
  auto mean = mean_of_varied(bubble.film, film, time_s);
  for (std::size_t i = 0; mean && i < film.layers.size(); ++i)
    if (i != film.varied_layer) *mean += film.layers[i].thickness_nm;
  return mean;
}

}  // namespace

std::optional<film::BubbleBody> body_of(const BubbleDesc& bubble, const Film& film, double metres_per_unit,
                                        double time_s, const Path& path, Problems& problems) {
  const Path body{&path, "body"};
  const auto mean_nm = mean_thickness_nm(bubble, film, time_s);
  if (problems.has(body)) return {};
  if (!mean_nm) {
    problems.add(body, "expected 'thickness_nm', the mean thickness, which no model gives for this film");
    return {};
  }
  if (!(*mean_nm > 0)) {
    problems.add(body, "expected a film with a mean thickness above 0 for a bubble that moves, got " +
                           value_text(*mean_nm) + " nm");
    return {};
  }
  const double usual_m = film.flow ? film.flow->radius_m : bubble.radius * metres_per_unit;
  const double radius_m = bubble.body.radius_m.value_or(usual_m);
  return film::BubbleBody{.radius_m = radius_m,
                          .thickness_m = *mean_nm * metres_per_nm,
                          .tension_n_m = bubble.body.tension_n_m,
                          .density_kg_m3 = bubble.body.density_kg_m3,
                          .inner_air_kg_m3 = bubble.body.inner_air_kg_m3,
                          .outer_air_kg_m3 = bubble.body.outer_air_kg_m3};
}

bool check_modes(const std::vector<film::ShapeMode>& modes, const film::BubbleBody& body, const Path& path,
                 Problems& problems) {
  const Path place{&path, "modes"};
  if (problems.has(place)) return false;
  double sum_m = 0;
  for (const film::ShapeMode& mode : modes) sum_m += std::abs(mode.amplitude_m);
  if (sum_m <= largest_tremble * body.radius_m) return true;
  problems.add(place, "expected amplitudes that add up to at most half the radius of " + value_text(body.radius_m) +
                          " m, got " + format_number(sum_m, 3) + " m: small oscillations end long before");
  return false;
}

geometry::LobedSphere trembling(const std::vector<film::ShapeMode>& modes, const film::BubbleBody& body,
                                double time_s) {
  geometry::LobedSphere shape;
  for (const film::ShapeMode& mode : modes) {
    const double now = film::swing(body, mode, time_s);
    shape.mean -= now * now / (2 * mode.degree + 1);
    shape.lobes.push_back({mode.degree, now, math::normalize(mode.axis)});
  }
  return shape;
}

bool check_popping(const Film& film, const Path& path, Problems& problems) {
  if (film.layers.size() == 1) return true;
  problems.add(Path{&path, "popping"},
               "expected a film of one layer, which can burst, got " + std::to_string(film.layers.size()) + " layers");
  return false;
}

void open_hole(Film& film, const film::Hole& hole, const film::BubbleBody& body, const math::Vec3d& from_centre) {
  if (!(hole.angle_rad > 0)) return;
  constexpr double gone = -2;  // below all cosines
  const bool left = hole.angle_rad < std::numbers::pi;
  const math::Vec3d axis = math::normalize(from_centre);
  film.thickness = film::HoledFilm{film::HeldField{film.thickness}, axis, left ? std::cos(hole.angle_rad) : gone};
  if (left) film.rim = Rim{axis, hole.angle_rad, hole.rim_radius_m / body.radius_m};
}

namespace {

// The rim's middle line lies on the sphere, within the hole, so that the rim touches the film from there.
std::optional<geometry::PlacedShape> shape_of(const Rim& rim, const Sphere& bubble) {
  const double angle = rim.angle_rad - 2 * std::asin(std::min(rim.thickness / 2, 1.0));
  const double ring = std::sin(angle);
  if (!(angle > 0 && rim.thickness > 0 && rim.thickness < ring)) return {};
  const double size = bubble.radius * ring;
  const math::Vec3d x = math::any_normal_to(rim.axis), z = math::cross(x, rim.axis);
  const geometry::Affine place{x * size, rim.axis * size, z * size,
                               bubble.center + rim.axis * (bubble.radius * std::cos(angle))};
  return geometry::place(geometry::Torus{rim.thickness / ring}, place);
}

Surface surface_of(const optics::Medium& space, const optics::Medium& liquid) {
  const Coating coating{.stack = {space, {}, liquid}, .varied = {}};
  if (is_transparent(liquid)) return DielectricSurface{.coating = coating, .roughness = {}};
  return ConductorSurface{.coating = coating, .roughness = {}};
}

}  // namespace

void add_rims(Scene& scene) {
  for (const Sphere& bubble : scene.spheres)
    for (int i = bubble.first_film; i < bubble.first_film + bubble.film_count; ++i) {
      Film& film = scene.films[static_cast<std::size_t>(i)];
      const auto rim = std::exchange(film.rim, {});
      const auto shape = rim ? shape_of(*rim, bubble) : std::nullopt;
      if (!shape) continue;
      scene.surfaces.push_back(surface_of(scene.medium, film.layers.front().medium));
      scene.objects.push_back({*shape, static_cast<int>(scene.surfaces.size()) - 1, bubble.place_in_file});
    }
}

std::optional<Bursting> bursting_of(const BubbleDesc& bubble, const Film& film, film::BubbleBody body) {
  const bool by_itself = film.flow->rupture.has_value();
  if (film.layers.size() > 1 || (!bubble.popping && !by_itself)) return {};
  if (!bubble.body.thickness_nm) body.thickness_m = 0;
  return Bursting{body, bubble.popping.value_or(film::PoppingDesc{}), by_itself};
}

}  // namespace shabon::scene
