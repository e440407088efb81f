// Maps of thickness by direction, and one for each frame.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "shabon/film/sphere_map.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/frames.h"

namespace shabon::scene {
namespace {

math::Raster grey(int width, int height, float value) {
  return {width, height, 1, std::vector<float>(static_cast<std::size_t>(width * height), value)};
}

// A folder of frames: film.0000.exr is 100 nm thick, film.0001.exr 200 nm and so on; the same as cubes; a smaller one.
struct Folder {
  std::set<std::string> read;

  Resources resources() {
    Resources resources;
    resources.texture = [this](const std::string& file) -> Result<TextureFile> {
      read.insert(file);
      if (file == "film.0009.exr") return TextureFile{grey(2, 2, 1000)};
      if (file.starts_with("film."))
        return TextureFile{grey(4, 2, 100.0f * (1 + static_cast<float>(std::stoi(file.substr(5)))))};
      if (file.starts_with("cube_"))
        return TextureFile{grey(3, 18, 100.0f * (1 + static_cast<float>(std::stoi(file.substr(5)))))};
      if (file == "top.exr") {
        math::Raster cube = grey(3, 18, 300);
        for (int i = 2 * 9; i < 3 * 9; ++i) cube.values[static_cast<std::size_t>(i)] = 900;
        return TextureFile{std::move(cube)};
      }
      return fail(Failure::file, "there is no " + file);
    };
    return resources;
  }

  Result<Scene> load(const std::string& map, double time_s = 0, const std::string& object = "") {
    const std::string text =
        "shabon: 1\ntime_s: " + std::to_string(time_s) + "\nenvironment: {constant: {}}\nobjects:\n  - " +
        (object.empty() ? "bubble: {film: {medium: water, thickness: {map: {" + map + "}}}}" : object) + "\n";
    read.clear();
    return load_scene(text, "test.yaml", {}, resources());
  }

  double nm_at(const std::string& map, double time_s) {
    const Result<Scene> scene = load(map, time_s);
    EXPECT_TRUE(scene.ok()) << map << "\n" << to_text(scene.errors());
    return scene ? film::thickness_nm(scene->films[0].thickness, math::Vec3d{0.6, 0.8, 0}) : 0;
  }
};

TEST(ThicknessMaps, follow_the_time_from_frame_to_frame) {
  Folder folder;
  const std::string map = "file: film.####.exr, frames_per_second: 10";
  EXPECT_FLOAT_EQ(static_cast<float>(folder.nm_at(map, 0)), 100);
  EXPECT_EQ(folder.read, (std::set<std::string>{"film.0000.exr"}));
  EXPECT_NEAR(folder.nm_at(map, 0.5), 600, 1e-3);
  EXPECT_EQ(folder.read, (std::set<std::string>{"film.0005.exr"}));
  EXPECT_NEAR(folder.nm_at(map, 0.325), 425, 1e-3);
  EXPECT_EQ(folder.read, (std::set<std::string>{"film.0003.exr", "film.0004.exr"}));
  EXPECT_NEAR(folder.nm_at(map + ", first_frame: 2, last_frame: 4", 0.15), 450, 1e-3);
  EXPECT_NEAR(folder.nm_at(map + ", first_frame: 2, last_frame: 4", 77), 500, 1e-3);
  EXPECT_EQ(folder.read, (std::set<std::string>{"film.0004.exr"}));
  EXPECT_NEAR(folder.nm_at("file: film.####.exr", 0.25), 700, 1e-3);  // 24 a second
}

TEST(ThicknessMaps, number_their_files) {
  const auto first = [](const std::string& file, int frame) {
    ThicknessMapDesc map;
    map.file = file, map.first_frame = frame;
    return frames_at(map, 0).first;
  };
  EXPECT_EQ(first("a.##.exr", 7), "a.07.exr");
  EXPECT_EQ(first("a.##.exr", 1234), "a.1234.exr");
  EXPECT_EQ(first("take#1/b_#.exr", 3), "take#1/b_3.exr");
  EXPECT_EQ(first("a.exr", 3), "a.exr");
}

TEST(ThicknessMaps, of_cubes_are_maps_by_direction_on_every_shape) {
  Folder folder;
  EXPECT_NEAR(folder.nm_at("file: cube_#, layout: cube", 1.5 / 24), 250, 1e-3);
  for (const std::string object : {"bubble: {film: FILM}", "quad: {surface: {film: {FILM}}}"}) {
    const std::string film = "medium: water, thickness: {map: {file: top.exr, layout: cube}}";
    std::string text = object;
    text.replace(text.find("FILM"), 4, object.starts_with("bubble") ? "{" + film + "}" : film);
    const Result<Scene> scene = folder.load("", 0, text);
    ASSERT_TRUE(scene) << to_text(scene.errors());
    const film::ThicknessField& field = scene->films.at(0).thickness;
    ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const film::SphereMap>>(field));
    EXPECT_FALSE(scene->films[0].thickness_map_nm);
    EXPECT_NEAR(film::thickness_nm(field, math::Vec3d{0.1, 1, 0.1}), 900, 60);
    EXPECT_NEAR(film::thickness_nm(field, math::Vec3d{0, -1, 0.1}), 300, 1e-3);
    EXPECT_NEAR(film::thickness_nm(field, math::Vec3d{1, 1, 0}), 600, 1e-3);  // the mean of both sides of an edge
  }
}

TEST(ThicknessMaps, lend_one_cube_to_all_who_name_it) {
  Folder folder;
  const Result<Scene> scene = folder.load(
      "", 0,
      "bubble: {film: {medium: water, thickness: {map: {file: top.exr, layout: cube}}}}\n"
      "  - bubble: {center: [5, 0, 0], film: {medium: water, thickness: {map: {file: top.exr, layout: cube}}}}");
  ASSERT_TRUE(scene);
  using Cube = std::shared_ptr<const film::SphereMap>;
  EXPECT_EQ(std::get<Cube>(scene->films[0].thickness), std::get<Cube>(scene->films[1].thickness));
}

TEST(ThicknessMaps, tell_what_is_wrong_with_a_frame) {
  Folder folder;
  const auto message = [&](const std::string& map, double time_s) {
    const Result<Scene> scene = folder.load(map, time_s);
    return scene ? std::string() : scene.errors().front().message;
  };
  EXPECT_EQ(message("file: film.####.exr", 8.5 / 24),
            "expected frames of one size, got 4 x 2 pixels in 'film.0008.exr' "
            "and 2 x 2 pixels in 'film.0009.exr'");
  EXPECT_EQ(message("file: none.#.exr", 1), "there is no none.24.exr");
  EXPECT_EQ(message("file: film.0.exr, layout: cube", 0),
            "'film.0.exr': expected a picture six times as high as wide, the faces of a "
            "cube below each other, got 4 x 2");
}

// The faces of a cube laid over latitude and longitude; other shapes are anyone's choice.
TEST(ThicknessMaps, warn_of_a_cube_that_is_laid_flat) {
  Folder folder;
  const auto warnings = [&](const std::string& map) {
    Diagnostics told;
    const std::string text =
        "shabon: 1\nenvironment: {constant: {}}\nobjects:\n  - bubble: {film: {medium: water, thickness: {map: {" +
        map + "}}}}\n";
    EXPECT_TRUE(load_scene(text, "test.yaml", {}, folder.resources(), &told).ok());
    return told;
  };
  const Diagnostics flat = warnings("file: top.exr");
  ASSERT_EQ(flat.size(), 1u);
  for (const char* part : {"'top.exr' has 3 x 18 pixels", "expected layout: cube"})
    EXPECT_NE(flat.front().message.find(part), std::string::npos) << flat.front().message;
  EXPECT_TRUE(warnings("file: top.exr, layout: cube").empty());
  EXPECT_TRUE(warnings("file: film.0.exr").empty());
}

TEST(Time, ages_the_films_of_a_scene) {
  Folder folder;
  const std::string film =
      "film: {medium: water, thickness: {noise: {amplitude: 0, base: {self_similar: {top_nm: 800, bottom_nm: 800, "
      "half_time_s: 4, age_s: 4}}}}}";
  for (const auto& [time_s, nm] : std::map<double, double>{{0, 400}, {4, 800.0 / 3}, {8, 200}}) {
    const Result<Scene> scene = folder.load("", time_s, "bubble: {" + film + "}");
    ASSERT_TRUE(scene) << to_text(scene.errors());
    EXPECT_EQ(scene->time_s, time_s);
    EXPECT_NEAR(film::thickness_nm(scene->films[0].thickness, math::Vec3d{0, 1, 0}), nm, 1e-9);
  }
}

}  // namespace
}  // namespace shabon::scene
