// The keys of a scene file: one list per struct of scene_desc.h. Those of the thickness models stand in film/.
#pragma once

#include <numbers>
#include <string_view>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/color/sunlight.h"
#include "shabon/scene/ranges.h"
#include "shabon/scene/scene_desc.h"
#include "shabon/scene/schema_build.h"

namespace shabon::scene {

inline constexpr Range version_range{.low = scene_file_version, .high = scene_file_version};

std::vector<std::string_view> transport_names();

constexpr auto fields(Of<RenderDesc>) {
  return std::tuple{
      Field{"samples", &RenderDesc::samples, {.range = samples_range, .doc = "camera samples per pixel"}},
      Field{"interference", &RenderDesc::interference, {.doc = "how much of the interference is computed"}},
      Field{"seed", &RenderDesc::seed, {.range = seed_range, .doc = "start of the random numbers"}},
      Field{"split_threshold",
            &RenderDesc::split_threshold,
            {.range = split_range, .doc = "branches that carry more are split, others chosen at random, (26)"}},
      Field{"max_depth",
            &RenderDesc::max_depth,
            {.range = depth_range, .doc = "surface events along one path; then (27) at films, and chance in solids"}},
      Field{"transport",
            &RenderDesc::transport,
            {.names = transport_names,
             .doc = "how paths are followed: both branches at a film, or one path, as a check"}}};
}

constexpr About about(Of<ConstantEnvironmentDesc>) {
  return {.name = "constant", .doc = "the same light from everywhere"};
}
constexpr auto fields(Of<ConstantEnvironmentDesc>) { return fields(Of<LampDesc>{}); }

constexpr About about(Of<GradientEnvironmentDesc>) { return {.name = "gradient", .doc = "two lamps mixed by height"}; }
constexpr auto fields(Of<GradientEnvironmentDesc>) {
  return std::tuple{
      Field{"up", &GradientEnvironmentDesc::up, {.required = true, .doc = "light from straight above"}},
      Field{"down", &GradientEnvironmentDesc::down, {.required = true, .doc = "light from straight below"}}};
}

constexpr About about(Of<ImageEnvironmentDesc>) {
  return {.name = "image", .doc = "a latitude-longitude picture, (25)"};
}
constexpr auto fields(Of<ImageEnvironmentDesc>) {
  return std::tuple{
      Field{"file",
            &ImageEnvironmentDesc::file,
            {.required = true, .doc = "OpenEXR or Radiance HDR picture, relative to the scene file"}},
      Field{
          "rotation_deg",
          &ImageEnvironmentDesc::rotation_deg,
          {.unit = "degrees", .range = angle_range_deg, .doc = "azimuth of the picture's middle, from -z towards +x"}},
      Field{"scale", &ImageEnvironmentDesc::scale, {.range = scale_range, .doc = "factor on the picture's values"}}};
}

constexpr About about(Of<SkyEnvironmentDesc>) { return {.name = "sky", .doc = "a clear sky, its sun and the ground"}; }
constexpr auto fields(Of<SkyEnvironmentDesc>) {
  return std::tuple{
      Field{"sun_elevation_deg",
            &SkyEnvironmentDesc::sun_elevation_deg,
            {.unit = "degrees", .range = elevation_range_deg, .doc = "height of the sun above the horizon"}},
      Field{"sun_azimuth_deg",
            &SkyEnvironmentDesc::sun_azimuth_deg,
            {.unit = "degrees", .range = angle_range_deg, .doc = "azimuth of the sun, from -z towards +x"}},
      Field{"turbidity",
            &SkyEnvironmentDesc::turbidity,
            {.range = color::turbidity_range, .doc = "haze: 2 is a very clear day, 10 a hazy one"}},
      Field{"scale",
            &SkyEnvironmentDesc::scale,
            {.range = scale_range, .doc = "brightness; with 1 a white card lying in the open has Y = 1"}},
      Field{"sun", &SkyEnvironmentDesc::sun, {.doc = "whether the sun itself is there; the sky stays as it is"}},
      Field{"ground_albedo",
            &SkyEnvironmentDesc::ground_albedo,
            {.range = share_range, .doc = "share of the light that the grey ground below the horizon reflects"}}};
}

constexpr About about(Of<RoundShapeDesc>) { return {.name = "round", .doc = "a disk", .flat = true}; }
constexpr auto fields(Of<RoundShapeDesc>) {
  return std::tuple{Field{"half_angle_deg",
                          &RoundShapeDesc::half_angle_deg,
                          {.unit = "degrees",
                           .range = up_to_half_turn_deg,
                           .required = true,
                           .doc = "round lamp: from its axis to its rim"}}};
}

constexpr About about(Of<WindowShapeDesc>) { return {.name = "window", .doc = "a flat rectangle", .flat = true}; }
constexpr auto fields(Of<WindowShapeDesc>) {
  return std::tuple{
      Field{"width_deg",
            &WindowShapeDesc::width_deg,
            {.unit = "degrees", .range = below_half_turn_deg, .required = true, .doc = "window: full angle across"}},
      Field{"height_deg",
            &WindowShapeDesc::height_deg,
            {.unit = "degrees", .range = below_half_turn_deg, .required = true, .doc = "window: full angle upwards"}},
      Field{"roll_deg",
            &WindowShapeDesc::roll_deg,
            {.unit = "degrees", .range = angle_range_deg, .doc = "window: turn about its axis, counter-clockwise"}}};
}

constexpr auto fields(Of<SoftboxDesc>) {
  constexpr FieldInfo direction{.range = coordinate_range, .required = true, .doc = "towards the lamp, of any length"};
  return std::tuple_cat(std::tuple{Field{"direction", &SoftboxDesc::direction, direction}, Choice{&SoftboxDesc::shape}},
                        fields(Of<LampDesc>{}));
}

constexpr auto fields(Of<EnvironmentDesc>) {
  return std::tuple{Choice{&EnvironmentDesc::base},
                    Field{"softboxes",
                          &EnvironmentDesc::softboxes,
                          {.doc = "lamps at infinity; their light adds to the base and to each other"}}};
}

constexpr auto fields(Of<SceneDesc>) {
  return std::tuple{
      Field{"shabon", &SceneDesc::shabon, {.range = version_range, .required = true, .doc = "version of the format"}},
      Field{"metres_per_unit",
            &SceneDesc::metres_per_unit,
            {.unit = "m",
             .range = unit_range_m,
             .doc = "length of the scene's unit, for the absorption in solids and how bubbles move"}},
      Field{"time_s",
            &SceneDesc::time_s,
            {.unit = "s", .range = time_range_s, .doc = "the moment the picture shows, for films that age"}},
      Field{"image", &SceneDesc::image, {.doc = "size of the picture; pixels are square"}},
      Field{"camera", &SceneDesc::camera, {.doc = "where the picture is taken from"}},
      Field{"render", &SceneDesc::render, {.doc = "how the picture is computed"}},
      Field{"environment",
            &SceneDesc::environment,
            {.required = true, .doc = "the light: exactly one base, any softboxes"}},
      Field{"objects", &SceneDesc::objects, {.doc = "what is seen"}}};
}

// Rules between members of one struct. They keep silent where the members themselves are wrong.
void check(const SoftboxDesc& softbox, const Path& path, Problems& problems);
void check(const ImageEnvironmentDesc& environment, const Path& path, Problems& problems);
void check(const SceneDesc& scene, const Path& path, Problems& problems);

}  // namespace shabon::scene
