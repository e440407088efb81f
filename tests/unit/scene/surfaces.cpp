// Every surface of the list is read from a scene file and compiled to what the renderer is given.
#include "shabon/scene/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "shabon/color/rgb_basis.h"
#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

Resources with_files() {
  Resources resources;
  resources.texture = [](const std::string& file) -> Result<TextureFile> {
    const bool png = file.ends_with(".png");
    if (file == "nm.exr") return TextureFile{{2, 1, 1, {200, 400}}};
    return TextureFile{{2, 1, 3, {0.25f, 0.5f, 0.75f, 1, 1, 1}}, png, png ? 8 : 0};
  };
  resources.reflectance = [](const std::string&) -> Result<color::Spectrum> {
    color::Spectrum spectrum;
    spectrum.fill(0.125);
    return spectrum;
  };
  return resources;
}

Scene load(const std::string& objects, Diagnostics* warnings = nullptr) {
  const std::string text = "shabon: 1\nenvironment: {constant: {}}\nobjects:\n" + objects;
  const Result<Scene> scene = load_scene(text, "test.yaml", {}, with_files(), warnings);
  EXPECT_TRUE(scene.ok()) << text << "\n" << to_text(scene.errors());
  return scene ? *scene : Scene{};
}

Scene load_surface(const std::string& surface) { return load("  - sphere: {surface: {" + surface + "}}\n"); }

template <class SurfaceType>
SurfaceType only(const Scene& scene) {
  EXPECT_EQ(scene.objects.size(), 1u);
  const Surface& surface = scene.surfaces.at(static_cast<std::size_t>(scene.objects.at(0).surface));
  EXPECT_TRUE(std::holds_alternative<SurfaceType>(surface));
  return std::get<SurfaceType>(surface);
}

// The shortest spelling of each; a surface that is new to the list is missed here.
const std::map<std::string_view, std::string> shortest = {
    {"film", "film: {medium: water, thickness: {constant_nm: 300}}"},
    {"dielectric", "dielectric: {stack: air | glass}"},
    {"conductor", "conductor: {stack: air | Ti}"},
    {"pane", "pane: {stack: air | glass 3mm incoherent | air}"},
    {"diffuse", "diffuse: {}"},
    {"glossy", "glossy: {stack: air | water}"},
    {"emitter", "emitter: {}"},
    {"mix", "mix: {surfaces: [{diffuse: {}}, {emitter: {}}]}"},
    {"mask", "mask: {surface: {diffuse: {}}}"},
};

template <std::size_t... I>
void check_list(std::index_sequence<I...>) {
  using Descs = decltype(SurfaceDesc::chosen);
  static_assert(sizeof...(I) == std::variant_size_v<Surface>);
  const auto check_one = [](auto index) {
    const std::string_view name = about(Of<std::variant_alternative_t<index(), Descs>>{}).name;
    ASSERT_TRUE(shortest.contains(name)) << name;
    for (const char* shape : {"sphere: {", "quad: {", "disk: {", "cylinder: {",
                              "triangle: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "}) {
      const Scene scene = load("  - " + std::string(shape) + "surface: {" + shortest.at(name) + "}}\n");
      ASSERT_EQ(scene.objects.size(), 1u);
      EXPECT_EQ(scene.surfaces.at(static_cast<std::size_t>(scene.objects[0].surface)).index(), index()) << name;
    }
  };
  (check_one(std::integral_constant<std::size_t, I>{}), ...);
}

TEST(Surfaces, all_of_the_list_stand_on_every_shape) {
  check_list(std::make_index_sequence<std::variant_size_v<decltype(SurfaceDesc::chosen)>>{});
}

TEST(Surfaces, a_coating_keeps_its_stack_and_the_layer_that_varies) {
  const auto surface =
      only<DielectricSurface>(load_surface("dielectric: {stack: air | MgF2 99nm | 2.1 60nm | glass, roughness: 0.25, "
                                           "vary: {layer: 2, thickness: {linear: {top_nm: 30, bottom_nm: 90}}}}"));
  ASSERT_EQ(surface.coating.stack.layers.size(), 2u);
  EXPECT_EQ(surface.coating.stack.layers[0].medium.name(), "MgF2");
  EXPECT_EQ(surface.coating.stack.layers[0].thickness_nm, 99);
  EXPECT_EQ(surface.coating.stack.layers[1].thickness_nm, 60);
  EXPECT_EQ(surface.coating.stack.incidence, optics::Medium());
  EXPECT_NEAR(surface.coating.stack.exit.index(587.6).real(), 1.5168, 1e-4);
  ASSERT_TRUE(surface.coating.varied);
  EXPECT_EQ(surface.coating.varied->layer, 1u);
  const auto& model = std::get<film::ThicknessField>(surface.coating.varied->thickness_nm);
  EXPECT_EQ(std::get<film::LinearThickness>(model).bottom_nm, 90);
  EXPECT_EQ(surface.roughness.at(0.3, 0.7), 0.25);
}

TEST(Surfaces, numbers_follow_pictures) {
  const auto metal = only<ConductorSurface>(
      load_surface("conductor: {stack: air | 1.5 30nm | Ti, roughness_map: {file: a.png, low: 0.8, "
                   "high: 0.2}, vary: {thickness: {map: {file: nm.exr, repeat: [2, 1]}}}}"));
  // Of colours the mean as it stands in the file: 0.5 and 1.
  EXPECT_NEAR(metal.roughness.at(0.25, 0.5), 0.8 - 0.6 * 0.5, 1e-6);
  EXPECT_NEAR(metal.roughness.at(0.75, 0.5), 0.2, 1e-6);
  const auto& thickness = std::get<NumberTexture>(metal.coating.varied->thickness_nm);
  EXPECT_NEAR(thickness.at(0.125, 0.5), 200, 1e-3);  // twice over the surface
  EXPECT_NEAR(thickness.at(0.375, 0.5), 400, 1e-3);
  EXPECT_NEAR(thickness.at(0.625, 0.5), 200, 1e-3);
  const auto rgb = only<DiffuseSurface>(load_surface("diffuse: {color_map: {file: a.png}}"));
  float linear[3] = {};
  rgb.color.coefficients(0.25, 0.5, linear);
  EXPECT_NEAR(linear[0], color::decode_srgb(0.25), 1e-6);  // encoded in a PNG
  EXPECT_NEAR(linear[2], color::decode_srgb(0.75), 1e-6);
  const auto floating = only<DiffuseSurface>(load_surface("diffuse: {color_map: {file: a.exr}}"));
  floating.color.coefficients(0.25, 0.5, linear);
  EXPECT_NEAR(linear[0], 0.25, 1e-6);
}

TEST(Surfaces, whole_numbers_span_the_thickness_asked_for) {
  const Scene scene = load_surface("film: {medium: water, thickness: {map: {file: a.png, low_nm: 100, high_nm: 500}}}");
  const auto surface = only<FreeFilmSurface>(scene);
  ASSERT_EQ(scene.films.size(), 1u);
  EXPECT_EQ(surface.first_film, 0);
  ASSERT_TRUE(scene.films[0].thickness_map_nm);
  EXPECT_NEAR(scene.films[0].thickness_map_nm->at(0.25, 0.5), 300, 1e-3);
  EXPECT_NEAR(scene.films[0].thickness_map_nm->at(0.75, 0.5), 500, 1e-3);
}

TEST(Surfaces, a_bubble_with_a_picture_is_a_bubble_like_others) {
  const Scene scene = load(
      "  - bubble: {film: {medium: 1.4, thickness: {constant_nm: 70}}}\n"
      "  - bubble: {center: [3, 0, 0], radius: 2, film: {medium: 1.5, thickness: {constant_nm: 10}}}\n"
      "  - bubble: {center: [3, 0, 0], radius: 2, film: {medium: 1.6, thickness: {map: {file: nm.exr}}}}\n");
  ASSERT_EQ(scene.spheres.size(), 2u);
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_EQ(scene.spheres[1].film_count, 2);
  const Film& film = scene.films[static_cast<std::size_t>(scene.spheres[1].first_film) + 1];
  EXPECT_FALSE(film.thickness_map_nm);
  // (0.25, 0.5) and (0.75, 0.5): the azimuth counts from +z through -x.
  EXPECT_NEAR(film::thickness_nm(film.thickness, math::Vec3d{-1, 0, 0}), 200, 1e-3);
  EXPECT_NEAR(film::thickness_nm(film.thickness, math::Vec3d{1, 0, 0}), 400, 1e-3);
}

TEST(Surfaces, colours_of_every_spelling_become_spectra_each_once) {
  const Scene scene = load(
      "  - quad: {position: [0, 0, 0], surface: {diffuse: {color: 0.25}}}\n"
      "  - quad: {position: [0, 0, 1], surface: {diffuse: {color: [0.25, 0.25, 0.25]}}}\n"
      "  - quad: {position: [0, 0, 2], surface: {diffuse: {color: '#ff0080'}}}\n"
      "  - quad: {position: [0, 0, 3], surface: {diffuse: {color: file:paint.csv}}}\n"
      "  - quad: {position: [0, 0, 4], surface: {diffuse: {color: 'file:paint.csv'}}}\n"
      "  - quad: {position: [0, 0, 6], surface: {diffuse: {color_map: {file: a.png}}}}\n"
      "  - quad: {position: [0, 0, 7], surface: {glossy: {stack: air | water, color_map: {file: a.exr}}}}\n");
  ASSERT_EQ(scene.reflectances.size(), 6u);  // grey, pink, paint, and the basis of pictures
  const auto first_channel = [&](std::size_t i) {
    return static_cast<std::size_t>(std::get<DiffuseSurface>(scene.surfaces.at(i)).color.first_channel);
  };
  EXPECT_EQ(first_channel(0), first_channel(1));
  EXPECT_EQ(first_channel(3), first_channel(4));
  EXPECT_EQ(std::get<GlossySurface>(scene.surfaces[6]).base.first_channel, static_cast<int>(first_channel(5)));
  EXPECT_NEAR(scene.reflectances[first_channel(0)][200], 0.25, 1e-12);
  const color::Spectrum pink = color::rgb_to_reflectance({1, 0, color::decode_srgb(128 / 255.0)});
  EXPECT_EQ(scene.reflectances[first_channel(2)], pink);
  EXPECT_EQ(scene.reflectances[first_channel(3)][7], 0.125);
  EXPECT_EQ(scene.reflectances[first_channel(5) + 1], color::rgb_basis().g);
}

TEST(Surfaces, emitters_share_the_channels_of_lamps) {
  const Scene scene = load(
      "  - quad: {position: [0, 0, 0], surface: {emitter: {scale: 7, both_sides: true}}}\n"
      "  - quad: {position: [0, 0, 1], surface: {emitter: {illuminant: A}}}\n");
  ASSERT_EQ(scene.environment.channels.size(), 2u);
  const auto& first = std::get<EmitterSurface>(scene.surfaces[0]);
  EXPECT_EQ(first.channel, 0);  // the environment's D65
  EXPECT_EQ(first.scale, 7);
  EXPECT_TRUE(first.both_sides);
  EXPECT_EQ(std::get<EmitterSurface>(scene.surfaces[1]).channel, 1);
}

TEST(Surfaces, parts_of_a_mix_are_listed_before_it) {
  const Scene scene = load_surface(
      "mix: {surfaces: [{mask: {surface: {diffuse: {}}, opacity: 0.75}}, {emitter: {}}], amount_map: {file: a.png}}");
  const int top = scene.objects.at(0).surface;
  const auto mix = only<MixSurface>(scene);
  EXPECT_LT(mix.first, top);
  EXPECT_LT(mix.second, top);
  const auto& mask = std::get<MaskSurface>(scene.surfaces[static_cast<std::size_t>(mix.first)]);
  EXPECT_LT(mask.surface, mix.first);
  EXPECT_EQ(mask.opacity.at(0, 0), 0.75);
  EXPECT_NEAR(mix.amount.at(0.25, 0.5), 0.5, 1e-6);
}

TEST(Surfaces, the_scene_is_filled_by_what_no_object_holds) {
  const std::string glass = "dielectric: {stack: air | glass}", water = "dielectric: {stack: glass | 1.33}";
  EXPECT_EQ(
      load("  - sphere: {radius: 0.5, surface: {" + water + "}}\n  - sphere: {surface: {" + glass + "}}\n").medium,
      optics::Medium());
  EXPECT_EQ(load_surface("conductor: {stack: 1.33 | Ti}").medium, optics::Medium::constant(1.33));
  EXPECT_EQ(load_surface("pane: {stack: 1.33 | glass 1mm incoherent | 1.33}").medium, optics::Medium::constant(1.33));
  // An air bubble in glass: each medium is behind the other; then air.
  EXPECT_EQ(load("  - sphere: {radius: 0.5, surface: {dielectric: {stack: glass | air}}}\n  - sphere: {surface: {" +
                 glass + "}}\n")
                .medium,
            optics::Medium());
  Diagnostics warnings;
  load("  - sphere: {surface: {" + glass + "}}\n  - sphere: {radius: 0.5, surface: {" + water + "}}\n", &warnings);
  EXPECT_EQ(to_text(warnings), "");
}

TEST(Surfaces, transport_and_units_reach_the_scene) {
  const Result<Scene> scene =
      load_scene("shabon: 1\nmetres_per_unit: 0.01\nrender: {transport: Path}\nenvironment: {constant: {}}\n",
                 "test.yaml", {}, {});
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene->metres_per_unit, 0.01);
  EXPECT_EQ(scene->render.transport, Transport::path);
}

}  // namespace
}  // namespace shabon::scene
