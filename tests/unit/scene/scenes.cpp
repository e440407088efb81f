// The gallery: every folder of scenes/ holds a scene that compiles, and a page about it.
#include <gtest/gtest.h>

#include <filesystem>

#include "shabon/api/resources.h"
#include "shabon/io/file.h"
#include "shabon/scene/built_in.h"
#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

namespace fs = std::filesystem;

const fs::path gallery = fs::path(SHABON_SOURCE_DIR) / "scenes";

TEST(Gallery, every_scene_compiles) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(gallery)) {
    if (!entry.is_directory()) continue;
    ++scenes;
    const Result<std::string> text = io::read_text_file(entry.path() / "scene.yaml", io::yaml_max_bytes);
    ASSERT_TRUE(text.ok()) << entry.path();
    const Result<Scene> scene = load_scene(*text, entry.path().string(), {}, api::file_resources(entry.path()));
    EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
    EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << entry.path();
  }
  EXPECT_GE(scenes, 4);
}

TEST(BuiltInScene, is_the_one_of_the_gallery_and_needs_no_files) {
  EXPECT_EQ(built_in_scene(), *io::read_text_file(gallery / "studio-bubble" / "scene.yaml", io::yaml_max_bytes));
  const Result<Scene> scene = load_scene(built_in_scene(), std::string(built_in_source), {}, {});
  ASSERT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_EQ(scene->spheres.size(), 1u);
}

}  // namespace
}  // namespace shabon::scene
