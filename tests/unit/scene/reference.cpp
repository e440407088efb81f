// docs/scene-file.md holds the table of all keys. SHABON_UPDATE_EXPECTED=1 writes it anew.
#include <gtest/gtest.h>

#include <cstdlib>

#include "shabon/io/file.h"
#include "shabon/scene/reference_table.h"
#include "shabon/scene/scene_file.h"

namespace shabon::scene {
namespace {

constexpr std::string_view page = SHABON_SOURCE_DIR "/docs/scene-file.md";
constexpr std::string_view begin_mark = "<!-- keys: begin -->\n", end_mark = "<!-- keys: end -->";
constexpr std::size_t most_bytes = 1 << 20;

TEST(SceneFilePage, holds_the_table_of_keys) {
  const Result<std::string> text = io::read_text_file(page, most_bytes);
  ASSERT_TRUE(text.ok());
  const std::size_t begin = text->find(begin_mark), end = text->find(end_mark);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::size_t first = begin + begin_mark.size();
  if (std::getenv("SHABON_UPDATE_EXPECTED") != nullptr) {
    const std::string updated = text->substr(0, first) + reference_table() + text->substr(end);
    ASSERT_TRUE(io::write_file_atomically(page, updated).ok());
  }
  EXPECT_EQ(io::read_text_file(page, most_bytes)->substr(first, end - first), reference_table())
      << "run this test with SHABON_UPDATE_EXPECTED=1 and read the page";
}

TEST(SceneFilePage, shows_an_example_that_can_be_read) {
  const Result<std::string> text = io::read_text_file(page, most_bytes);
  ASSERT_TRUE(text.ok());
  const std::string_view fence = "```yaml\n";
  const std::size_t begin = text->find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t first = begin + fence.size();
  const std::string example = text->substr(first, text->find("```", first) - first);
  const Result<SceneDesc> scene = read_scene(example, "example");
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
}

}  // namespace
}  // namespace shabon::scene
