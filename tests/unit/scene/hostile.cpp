// Files that want to be large, deep or slow: each is answered in moderate time and memory.
#include <gtest/gtest.h>

#include <chrono>

#include "shabon/scene/compile.h"
#include "shabon/scene/scene_file.h"

namespace shabon::scene {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double patience_s = 200;  // unoptimised, checked at every step, beside other work
#else
constexpr double patience_s = 10;  // on a slow machine; about 1 s is usual
#endif

template <class Work>
auto in_time(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), patience_s);
  return result;
}

const std::string head = "shabon: 1\nenvironment: {constant: {}}\n";

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(HostileScene, a_film_named_a_thousand_times_is_one_scene) {
  const std::string text = head + "objects:\n  - bubble: &b {film: {medium: water, thickness: {constant_nm: 300}}}\n" +
                           repeated("  - bubble: *b\n", 5000);
  const Result<Scene> scene = in_time([&] { return load_scene(text, "test.yaml", {}, {}); });
  ASSERT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_EQ(scene->spheres.size(), 1u);
  EXPECT_EQ(scene->films.size(), 5001u);
}

TEST(HostileScene, aliases_that_grow_a_thousandfold_are_refused) {
  std::string text = head + "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1) + ", ";
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + repeated(alias, 9) + alias + "]\n";
  }
  const auto scene = in_time([&] { return read_scene(text, "test.yaml"); });
  ASSERT_FALSE(scene.ok());
  EXPECT_LT(scene.errors().size(), 20u);
}

TEST(HostileScene, an_error_repeated_by_aliases_is_cut_short) {
  const std::string text =
      head + "objects:\n  - bubble: &b {radius: -1, film: {medium: watr, thickness: {constant_nm: -3}}}\n" +
      repeated("  - bubble: *b\n", 50000);
  const auto scene = in_time([&] { return read_scene(text, "test.yaml"); });
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.errors().size(), Problems::most_shown + 1);
}

TEST(HostileScene, many_unknown_keys_are_cut_short) {
  std::string text = head;
  for (int i = 0; i < 100000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  const auto scene = in_time([&] { return read_scene(text, "test.yaml"); });
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.errors().size(), Problems::most_shown + 1);
}

TEST(HostileScene, one_line_of_megabytes_is_shown_without_its_text) {
  const std::string text =
      "{shabon: 1, environment: {constant: {}}, objects: [" +
      repeated("{bubble: {radius: 0, film: {medium: 1.5, thickness: {constant_nm: 1}}}}, ", 50000) + "]}";
  const auto scene = in_time([&] { return read_scene(text, "test.yaml"); });
  ASSERT_FALSE(scene.ok());
  std::size_t bytes = 0;
  for (const Diagnostic& error : scene.errors()) bytes += error.excerpt.size();
  EXPECT_LT(bytes, 1u << 20);
}

TEST(HostileScene, a_hundred_thousand_bubbles_compile) {
  std::string text = head + "objects:\n";
  for (int i = 0; i < 60000; ++i)
    text += "- {bubble: {center: [" + std::to_string(i) + ", 0, 0], film: {stack: air | 1.5 3nm | air}}}\n";
  const auto scene = in_time([&] { return load_scene(text, "test.yaml", {}, {}); });
  ASSERT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_EQ(scene->spheres.size(), 60000u);
}

TEST(HostileScene, surfaces_within_each_other_are_counted) {
  const std::string leaf = "{diffuse: {}}";
  std::string deep = leaf, wide = leaf;
  for (int i = 0; i < 20; ++i) deep = "{mask: {surface: " + deep + "}}";
  for (int i = 0; i < 15; ++i) wide = "{mix: {surfaces: [" + wide + ", " + wide + "]}}";
  for (const std::string& surface : {deep, wide}) {
    const auto scene = in_time(
        [&] { return load_scene(head + "objects: [{quad: {surface: " + surface + "}}]\n", "test.yaml", {}, {}); });
    ASSERT_FALSE(scene.ok());
    EXPECT_NE(to_text(scene.errors()).find("within one surface"), std::string::npos) << to_text(scene.errors());
  }
}

TEST(HostileScene, many_objects_of_many_media_compile) {
  std::string text = head + "objects:\n";
  for (int i = 0; i < 20000; ++i) {
    const std::string n = std::to_string(1.1 + 1e-5 * i), m = std::to_string(1.2 + 1e-5 * i);
    text += "- {quad: {position: [0, 0, -" + std::to_string(i) + "], surface: {dielectric: {stack: " + n + " | " + m +
            "}}}}\n";
  }
  const auto scene = in_time([&] { return load_scene(text, "test.yaml", {}, {}); });
  ASSERT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_EQ(scene->objects.size(), 20000u);
}

TEST(HostileScene, thousands_of_objects_on_one_spot_are_told_once_each_at_most) {
  const std::string text =
      head + "objects:\n  - quad: &q {surface: {diffuse: {}}}\n" + repeated("  - quad: *q\n", 3000);
  Diagnostics warnings;
  const auto scene = in_time([&] { return load_scene(text, "test.yaml", {}, {}, &warnings); });
  ASSERT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_LE(warnings.size(), Problems::most_shown);
}

TEST(HostileScene, long_texts_are_cut_in_messages) {
  const std::string text = head + "objects: [{bubble: {film: {medium: " + std::string(100000, 'x') +
                           ", thickness: {constant_nm: " + std::string(100000, '9') + "}}}}]\n";
  const auto scene = in_time([&] { return read_scene(text, "test.yaml"); });
  ASSERT_FALSE(scene.ok());
  EXPECT_LT(to_text(scene.errors()).size(), 5000u);
}

TEST(HostileScene, control_characters_do_not_reach_the_terminal) {
  const auto scene = read_scene(head + "\"\\e[31mred\": 1\n", "test.yaml");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(to_text(scene.errors()).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace shabon::scene
