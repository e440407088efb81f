#include "shabon/render/kernel/scattering/tables.h"

#include <numbers>

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// The shapes of the objects, then of the bubbles.
std::vector<geometry::PlacedShape> placed_shapes(const scene::Scene& scene) {
  std::vector<geometry::PlacedShape> shapes;
  for (const scene::Object& object : scene.objects) shapes.push_back(object.shape);
  for (const scene::Sphere& sphere : scene.spheres) {
    const double r = sphere.radius;
    shapes.push_back(geometry::place(geometry::SphereCap{}, geometry::placement(sphere.center, {0, 0, 0}, {r, r, r})));
  }
  return shapes;
}

std::vector<ShapeTable> shape_tables(const scene::Scene& scene) {
  std::vector<ShapeTable> tables;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    ShapeTable table{.surface = scene.objects[i].surface, .object = static_cast<int>(i)};
    const scene::Surface& surface = scene.surfaces[static_cast<std::size_t>(table.surface)];
    if (const auto* film = std::get_if<scene::FreeFilmSurface>(&surface))
      table.first_film = film->first_film, table.film_count = film->film_count;
    tables.push_back(table);
  }
  for (const scene::Sphere& sphere : scene.spheres)
    tables.push_back({.first_film = sphere.first_film, .film_count = sphere.film_count});
  return tables;
}

template <class Function>
std::vector<LanesD> rows(const std::vector<Comb>& combs, const Function& function) {
  std::vector<LanesD> result;
  for (const Comb& comb : combs) {
    double values[lane_count];
    for (int i = 0; i < lane_count; ++i) values[i] = function(comb.wavelength_nm[i]);
    result.push_back(LanesD::load(values));
  }
  return result;
}

std::vector<Lanes> in_float(const std::vector<LanesD>& rows) {
  std::vector<Lanes> result;
  for (const LanesD& row : rows) result.push_back(math::convert<float>(row));
  return result;
}

// Collects the media that light runs through.
class Spaces {
 public:
  Spaces(const scene::Scene& scene, const std::vector<Comb>& combs) : scene_(scene), combs_(combs) {
    number(scene.medium);
  }

  int number(const optics::Medium& medium) {
    for (std::size_t i = 0; i < media_.size(); ++i)
      if (media_[i] == medium) return static_cast<int>(i);
    media_.push_back(medium);
    SpaceTable& space = tables.emplace_back();
    space.absorbs = !medium.is_lossless();
    const double nm_per_unit = scene_.metres_per_unit * 1e9;
    if (space.absorbs)
      space.log2_loss_per_unit = in_float(rows(combs_, [&](double nm) {
        return 4 * std::numbers::pi * std::numbers::log2e * medium.index(nm).imag() / nm * nm_per_unit;
      }));
    return static_cast<int>(media_.size()) - 1;
  }

  std::vector<SpaceTable> tables;

 private:
  const scene::Scene& scene_;
  const std::vector<Comb>& combs_;
  std::vector<optics::Medium> media_;
};

struct SurfaceTables {
  const std::vector<Comb>& combs;
  Spaces& spaces;

  template <class Surface>
  SurfaceTable coated(const Surface& s, RestGoes rest) const {
    const auto number = [this](const optics::Medium& medium) { return spaces.number(medium); };
    return {coating_table(s.coating, s.roughness, rest, combs, number), nullptr};
  }
  SurfaceTable operator()(const scene::DielectricSurface& s) const { return coated(s, RestGoes::spread); }
  SurfaceTable operator()(const scene::ConductorSurface& s) const { return coated(s, RestGoes::nowhere); }
  SurfaceTable operator()(const scene::GlossySurface& s) const { return coated(s, RestGoes::behind); }
  SurfaceTable operator()(const scene::PaneSurface& s) const {
    return {nullptr, std::make_unique<PaneTable>(s.stack, combs)};
  }
  template <class Other>
  SurfaceTable operator()(const Other&) const {
    return {};
  }
};

std::vector<Comb> combs_of(const scene::Scene& scene) {
  return wavelength_combs(color::observer_1931(), scene.environment.channels);
}

}  // namespace

int space_at(const ScatteringTables& tables, math::Vec3d origin, math::Vec3d direction) {
  int from = geometry::no_shape;
  constexpr int most_surfaces = 64;
  for (int met = 0; met < most_surfaces; ++met) {
    const auto hit = tables.shapes.next(origin, direction, from);
    if (!hit) return 0;
    const geometry::PlacedShape& shape = tables.shapes.shapes()[static_cast<std::size_t>(hit->shape)];
    const geometry::SurfacePoint point = geometry::surface_at(shape, origin, direction, hit->distance);
    const int surface = tables.shape[static_cast<std::size_t>(hit->shape)].surface;
    const CoatingTable* coating =
        surface >= 0 ? tables.surfaces[static_cast<std::size_t>(surface)].coating.get() : nullptr;
    if (coating != nullptr)
      return math::dot(direction, point.normal) < 0 ? coating->space_in_front : coating->space_behind;
    origin = point.position, from = hit->shape;
  }
  return 0;
}

ScatteringTables::ScatteringTables(const scene::Scene& of, std::optional<std::vector<Comb>> chosen)
    : scene(of), films(of, {}, chosen), shapes(placed_shapes(of)), shape(shape_tables(of)), lamps(of) {
  const std::vector<Comb> combs = chosen ? *std::move(chosen) : combs_of(of);
  Spaces found(of, combs);
  for (const scene::Surface& surface : of.surfaces)
    surfaces.push_back(std::visit(SurfaceTables{combs, found}, surface));
  spaces = std::move(found.tables);
  reflectance_count = of.reflectances.size();
  for (const Comb& comb : combs)
    for (const color::Spectrum& reflectance : of.reflectances) {
      double values[lane_count];
      for (int i = 0; i < lane_count; ++i) values[i] = at_wavelength(reflectance, comb.wavelength_nm[i]);
      reflectances.push_back(math::convert<float>(LanesD::load(values)));
    }
  camera_space = space_at(*this, of.camera.position, of.camera.forward);
  camera_spaces_differ = !of.camera.rays_begin_in_one_point() &&
                         std::any_of(spaces.begin(), spaces.end(), [](const SpaceTable& s) { return s.absorbs; });
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
