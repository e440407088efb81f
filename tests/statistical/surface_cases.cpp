#include "tests/statistical/surface_cases.h"

#include <cctype>
#include <numbers>

#include "shabon/color/illuminant.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::testing_surfaces {

namespace {

using scene::Scene;

optics::Stack stack(const std::string& text) { return *optics::parse_stack(text); }

scene::Coating coating(const std::string& text) { return {stack(text), {}}; }

int add_surface(Scene& scene, scene::Surface surface) {
  scene.surfaces.push_back(std::move(surface));
  return static_cast<int>(scene.surfaces.size()) - 1;
}

int add_reflectance(Scene& scene, double value) {
  color::Spectrum spectrum;
  spectrum.fill(value);
  scene.reflectances.push_back(spectrum);
  return static_cast<int>(scene.reflectances.size()) - 1;
}

template <class Surface>
auto coated(const std::string& text, double roughness) {
  return [=](Scene& scene) {
    Surface surface;
    surface.coating = coating(text);
    surface.roughness.constant = roughness;
    return add_surface(scene, surface);
  };
}

auto glossy(const std::string& text, double roughness, double base) {
  return [=](Scene& scene) {
    scene::GlossySurface surface;
    surface.coating = coating(text);
    surface.roughness.constant = roughness;
    surface.base.first_channel = add_reflectance(scene, base);
    return add_surface(scene, surface);
  };
}

auto diffuse(double reflectance) {
  return [=](Scene& scene) {
    scene::DiffuseSurface surface;
    surface.color.first_channel = add_reflectance(scene, reflectance);
    return add_surface(scene, surface);
  };
}

auto film(const std::string& medium, double thickness_nm) {
  return [=](Scene& scene) {
    const optics::Stack layers = stack("air | " + medium + " " + std::to_string(thickness_nm) + "nm | air");
    scene.films.push_back({layers.layers, 0, film::ConstantThickness{thickness_nm}});
    return add_surface(scene, scene::FreeFilmSurface{static_cast<int>(scene.films.size()) - 1, 1});
  };
}

}  // namespace

std::vector<SurfaceCase> surface_cases() {
  using D = scene::DielectricSurface;
  using C = scene::ConductorSurface;
  // A metal without loss: its index is imaginary.
  const std::string mirror = "air | 3i";
  return {
      {"film", true, 0, film("water", 400)},
      {"film of silver", false, 0, film("Ag", 10)},
      {"pane", true, 0,
       [](Scene& s) {
         return add_surface(s, scene::PaneSurface{stack("air | 1.38 99nm | 1.52 3mm incoherent | air")});
       }},
      {"dark pane", false, 0,
       [](Scene& s) {
         return add_surface(s, scene::PaneSurface{stack("air | 1.5+1e-5i 3mm incoherent | 2.3 60nm | air")});
       }},
      {"glass", true, 0, coated<D>("air | 1.5", 0), true},
      {"dispersive glass", true, 0, coated<D>("air | BK7", 0), true},
      {"coated glass", true, 0, coated<D>("air | 1.38 99.6nm | 1.52", 0), true},
      {"frosted glass", true, 0.015, coated<D>("air | 1.5", 0.3), true},
      {"slightly rough glass", true, 0, coated<D>("air | 1.5", 0.1), true},
      {"rough dispersive glass", true, 0, coated<D>("air | BK7", 0.1), true},
      {"mirror", true, 0, coated<C>(mirror, 0)},
      {"rough mirror", true, 0, coated<C>(mirror, 0.4)},
      {"very rough mirror", true, 0, coated<C>(mirror, 1)},
      {"titanium, anodised", false, 0, coated<C>("air | TiO2 60nm | Ti", 0.2)},
      {"white", true, 0, diffuse(1)},
      {"grey", false, 0, diffuse(0.5)},
      {"lacquer on white", true, 0, glossy("air | 1.5", 0, 1)},
      {"rough lacquer on white", true, 0, glossy("air | 1.5", 0.2, 1)},
      {"oil on water on white", true, 0, glossy("air | 1.47 300nm | 1.33", 0, 1)},
      {"lacquer on black", false, 0, glossy("air | 1.5", 0.1, 0)},
      {"lamp", true, 0,
       [](Scene& s) {
         return add_surface(s, scene::EmitterSurface{0, 1, true});
       }},
      {"half mirror, half white", true, 0,
       [=](Scene& s) {
         const int a = coated<C>(mirror, 0)(s), b = diffuse(1)(s);
         return add_surface(s, scene::MixSurface{a, b, {0.5, {}}});
       }},
      {"holes in white", true, 0,
       [](Scene& s) {
         const int a = diffuse(1)(s);
         return add_surface(s, scene::MaskSurface{a, {0.3, {}}});
       }},
  };
}

std::string test_name(const SurfaceCase& surface) {
  std::string name;
  for (const char c : surface.name)
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name;
}

std::vector<bool> kinds_covered() {
  std::vector<bool> covered(std::variant_size_v<scene::Surface>);
  for (const SurfaceCase& each : surface_cases()) {
    Scene scene = lit_from_everywhere(1, 1, 1);
    const int added = each.add(scene);
    covered[scene.surfaces[static_cast<std::size_t>(added)].index()] = true;
  }
  return covered;
}

Scene lit_from_everywhere(int width, int height, double vertical_fov_deg) {
  Scene scene;
  scene.width = width, scene.height = height;
  scene.metres_per_unit = 1e-4;  // glass does not fade light over such lengths
  scene.camera =
      scene::look_at_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, vertical_fov_deg * std::numbers::pi / 180, width, height);
  scene.environment.channels.push_back(color::lamp_radiance(*color::illuminant_named("D65")));
  scene.environment.base = scene::ConstantLight{0, 1};
  return scene;
}

void add_object(Scene& scene, const geometry::Shape& shape, const geometry::Affine& place, int surface) {
  scene.objects.push_back({geometry::place(shape, place), surface, static_cast<int>(scene.objects.size())});
}

}  // namespace shabon::testing_surfaces
