// Every message about a scene file has a fixture: tests/data/scenes/bad/NAME.yaml is a file with something wrong,
// NAME.set (optional) holds overrides, NAME.txt the text that people see. SHABON_UPDATE_EXPECTED=1 writes the texts
// anew; then read them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "shabon/base/text.h"
#include "shabon/io/image.h"
#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(SHABON_TEST_DATA) / "scenes" / "bad";

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::istringstream stream(content_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

// n-k files are read by another room; here they all are wrong at the same place.
Result<optics::Medium> broken_files(std::string_view name, bool is_file) {
  if (!is_file) return optics::resolve_from_library(name, is_file);
  Diagnostics errors = fail(Failure::content, "expected a number, got x");
  errors.front().source = name;
  errors.front().line = 2;
  errors.front().column = 5;
  return errors;
}

Result<color::Illuminant> lamps(std::string_view text) {
  const auto file = color::illuminant_file(text);
  if (!file) return color::illuminant_named(text);
  if (*file == "red.csv")
    return color::illuminant_from_samples("file:red.csv", "", std::array{640.0, 650.0, 660.0},
                                          std::array{0.0, 1.0, 0.0});
  if (*file != "short.csv") return broken_files(*file, true).errors();
  return color::illuminant_from_samples("file:short.csv", "", std::array{400.0, 700.0}, std::array{1.0, 1.0});
}

io::RgbImage one_pixel(std::vector<float> rgb, int negatives = 0) {
  io::RgbImage image;
  image.width = image.height = 1;
  image.rgb = std::move(rgb);
  image.negatives = negatives;
  return image;
}

Result<io::RgbImage> pictures(const std::string& file) {
  if (file == "negative.exr") return one_pixel({0, 0, 1}, 2);
  if (file == "nan.exr") return one_pixel({0, 0, std::nanf("")});
  if (file == "black.exr") return one_pixel({0, 0, 0});
  return io::read_image(folder / file);
}

Result<TextureFile> textures(const std::string& file) {
  const bool whole_numbers = file == "grey.png";
  const auto picture = [&](int channels, std::vector<float> values, int negatives = 0) {
    return TextureFile{{2, 1, channels, std::move(values)}, whole_numbers, whole_numbers ? 8 : 0, negatives};
  };
  if (file == "grey.png") return picture(1, {0, 0.5f});
  if (file == "large.exr") return picture(3, {0, 0, 1, 1, 2, 3}, 4);
  if (file == "nm.exr") return picture(1, {300, 800});
  if (file == "unit.exr") return picture(1, {0.1f, 0.98f});
  if (file == "dips.exr") return picture(3, {0, 0, 0.5f, 0.5f, 0.5f, 0.5f}, 2);
  if (file == "grow.0.exr") return picture(1, {300, 400});
  if (file == "grow.1.exr") return TextureFile{{1, 1, 1, {300}}};
  if (file == "faces.exr") return TextureFile{{2, 12, 1, std::vector<float>(24, 300)}};
  if (file == "huge.exr") return picture(1, {300, 1e7f});
  if (file == "nan.exr") return picture(1, {1, std::nanf("")});
  if (file == "four_channels.exr") return picture(4, {0, 0, 0, 1, 0, 0, 0, 1});
  return pictures(file).errors();
}

Result<color::Spectrum> reflectances(const std::string& file) { return broken_files(file, true).errors(); }

// What a program would print, without the name of this machine's folder.
std::string messages_of(const std::string& name) {
  Resources resources;
  resources.medium = broken_files;
  if (!name.starts_with("no_files")) resources.illuminant = lamps;
  if (!name.starts_with("no_files")) {
    resources.picture = pictures;
    resources.texture = textures;
    resources.reflectance = reflectances;
  }
  Diagnostics warnings;
  const Result<Scene> scene = load_scene(content_of(folder / (name + ".yaml")), "scene.yaml",
                                         lines_of(folder / (name + ".set")), resources, &warnings);
  std::string text = to_text(warnings);
  if (!scene) text += to_text(scene.errors());
  const std::string here = folder.string() + "/";
  for (std::size_t at = text.find(here); at != std::string::npos; at = text.find(here)) text.erase(at, here.size());
  return text;
}

class SceneFixture : public testing::TestWithParam<std::string> {};

TEST_P(SceneFixture, says_what_is_expected) {
  const std::string text = messages_of(GetParam());
  const fs::path expected = folder / (GetParam() + ".txt");
  if (std::getenv("SHABON_UPDATE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << text;
  EXPECT_FALSE(text.empty());
  EXPECT_EQ(text, content_of(expected));
}

INSTANTIATE_TEST_SUITE_P(bad, SceneFixture, testing::ValuesIn(case_names()),
                         [](const auto& fixture) { return fixture.param; });

// Texts that no fixture can provoke, with the reason.
const std::vector<std::string_view> without_fixture = {
    "the scene does not fit into memory",  // needs a machine without memory
    "expected a finite number, got ",      // only a description written in code holds nan: tests/unit/scene
    " | vacuum",                           // no message
    "expected a thickness model or a map; a simulated film has to run first, and its pictures are a map",  // no scene
};

// The parts of messages as they stand in the sources: string literals of two words or more. Descriptions of keys are
// not messages; they stand in the lists of schema_fields.h and in the table's own file.
std::vector<std::string> message_parts() {
  std::vector<std::string> parts;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(SHABON_SOURCE_DIR) / "shabon" / "scene")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "reference_table.cpp") continue;
    for (const std::string& line : lines_of(entry.path())) {
      if (trim(line).starts_with("//") || line.starts_with("#include")) continue;
      static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
      for (std::sregex_iterator it(line.begin(), line.end(), literal), end; it != end; ++it) {
        const std::string text = (*it)[1].str();
        const std::string_view words = trim(text);
        if (words.find(' ') != std::string_view::npos) parts.push_back(text);
      }
    }
  }
  return parts;
}

TEST(SceneMessages, all_have_a_fixture) {
  std::string seen;
  for (const std::string& name : case_names()) seen += content_of(folder / (name + ".txt"));
  const std::vector<std::string> parts = message_parts();
  EXPECT_GT(parts.size(), 30u);
  for (const std::string& part : parts) {
    const bool excused = std::find(without_fixture.begin(), without_fixture.end(), part) != without_fixture.end();
    EXPECT_TRUE(excused || seen.find(part) != std::string::npos) << "no file of " << folder << " provokes: " << part;
  }
}

}  // namespace
}  // namespace shabon::scene
