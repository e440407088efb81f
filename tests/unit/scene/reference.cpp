// docs/scene-file.md holds the table of all keys. SHABON_UPDATE_EXPECTED=1 writes it anew.
#include <gtest/gtest.h>

#include <cstdlib>

#include "shabon/io/file.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/reference_table.h"

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

TEST(SceneFilePage, shows_examples_that_can_be_read) {
  const Result<std::string> text = io::read_text_file(page, most_bytes);
  ASSERT_TRUE(text.ok());
  const std::string_view fence = "```yaml\n";
  int examples = 0;
  for (std::size_t begin = text->find(fence); begin != std::string::npos; begin = text->find(fence, begin + 1)) {
    const std::size_t first = begin + fence.size();
    std::string example = text->substr(first, text->find("```", first) - first);
    if (example.starts_with("objects:")) example = "shabon: 1\nenvironment: {constant: {}}\n" + example;
    Diagnostics warnings;
    const Result<Scene> scene = load_scene(example, "example", {}, {}, &warnings);
    EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
    EXPECT_EQ(to_text(warnings), "");
    ++examples;
  }
  EXPECT_GE(examples, 2);
}

}  // namespace
}  // namespace shabon::scene
