// Tests derived from the schema: every key of a scene file, whatever keys there will be.
#include "shabon/scene/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "shabon/base/text.h"
#include "shabon/scene/scene_file.h"
#include "shabon/scene/value.h"

namespace shabon::scene {
namespace {

using Visit = std::function<void(const Mapping&, const Key&, const std::string& path)>;

// A mapping within itself is not followed further.
void for_each_key(const Mapping& mapping, const std::string& above, const Visit& visit,
                  std::vector<const Mapping*> on_the_way = {}) {
  if (std::find(on_the_way.begin(), on_the_way.end(), &mapping) != on_the_way.end()) return;
  on_the_way.push_back(&mapping);
  for (const Key& key : mapping.keys) {
    const std::string path = above + (above.empty() ? "" : ".") + std::string(key.key);
    visit(mapping, key, path);
    if (key.below != nullptr) for_each_key(key.below(), path + (key.is_list ? "[0]" : ""), visit, on_the_way);
  }
}

// A value of the right kind that is allowed, so that a file with all the keys can be written.
std::string allowed_value(const Key& key) {
  if (key.info.names != nullptr) return std::string(key.info.names().front());
  if (key.type == type_text(Of<math::Vec3d>{}, key.info)) return "[1, 2, " + std::to_string(key.key.size()) + "]";
  if (key.type == type_text(Of<optics::Interference>{}, key.info)) return "none";
  if (key.type == type_text(Of<bool>{}, key.info)) return "true";
  if (key.type == type_text(Of<Repeat>{}, key.info)) return "[2, 3]";
  if (key.type == type_text(Of<ColorDesc>{}, key.info)) return "'#8040ff'";
  if (key.key == "corners") return "[[0, 0, 0], [1, 2, 0], [0, 1, 7]]";
  if (key.key == "radius") return "1000000";  // larger than any hole
  if (key.key == "illuminant" || key.key == "white_balance") return "blackbody:3000K";
  if (key.key == "turbidity") return "3";
  for (const std::string_view upper : {"to_deg", "to_nm", "nucleation_nm", "longest_s"})  // above its other half
    if (key.key == upper) return value_text(key.info.range.high);
  if (key.key == "medium") return "1.5";
  if (key.key == "file") return "picture.#";
  if (key.key == "first_frame") return "0";  // before any last one
  if (key.key == "stack") return "air | water 300nm | air";
  if (key.type == type_text(Of<std::string>{}, key.info)) return "text";
  if (key.info.range.contains(1)) return "1";
  EXPECT_TRUE(key.info.range.contains(key.info.range.low)) << key.key;
  return value_text(key.info.range.low);
}

// What each projection alone takes cannot stand together.
constexpr std::string_view of_perspective = "camera.vertical_fov_deg", of_orthographic = "camera.orthographic_height";

// A whole file in JSON that holds `path` with `value`; of every choice the one that `path` wants, else the first.
std::string file_with(const Mapping& mapping, const std::string& above, const std::string& path,
                      const std::string& value) {
  int wanted = 0;
  for (const Key& key : mapping.keys) {
    const std::string here = above + (above.empty() ? "" : ".") + std::string(key.key);
    const bool on_the_way =
        path.starts_with(here) && (path.size() == here.size() || path[here.size()] == '.' || path[here.size()] == '[');
    if (on_the_way && key.choice != Key::common) wanted = key.choice;
  }
  std::string text;
  for (const Key& key : mapping.keys) {
    if (key.choice != Key::common && key.choice != wanted) continue;
    const std::string here = above + (above.empty() ? "" : ".") + std::string(key.key);
    std::string content;
    if (key.below == nullptr)
      content = allowed_value(key);
    else if (!key.is_list)
      content = file_with(key.below(), here, path, value);
    else
      for (int i = 0; i < std::max(key.info.items, 1); ++i)
        content += (i == 0 ? "[" : ", ") + file_with(key.below(), here + "[" + std::to_string(i) + "]", path, value);
    if (key.below != nullptr && key.is_list) content += "]";
    if (here == "camera.projection" && path == of_orthographic) content = "orthographic";
    if (here == path) content = value;
    if (here == (path == of_orthographic ? of_perspective : of_orthographic)) continue;
    if (content == "(none)") continue;
    text += (text.empty() ? "" : ", ") + std::string(key.key) + ": " + content;
  }
  return "{" + text + "}";
}

std::string errors_of(const std::string& path, const std::string& value) {
  const Result<SceneDesc> scene = read_scene(file_with(scene_schema(), "", path, value), "test.yaml");
  return scene ? "" : to_text(scene.errors());
}

TEST(Schema, keys_are_different_within_a_mapping_and_documented) {
  for_each_key(scene_schema(), "", [](const Mapping& mapping, const Key& key, const std::string& path) {
    int times = 0;
    for (const Key& other : mapping.keys) times += other.key == key.key;
    EXPECT_EQ(times, 1) << path;
    EXPECT_FALSE(key.info.doc.empty()) << path;
    EXPECT_EQ(key.key, lower(key.key)) << path;
    EXPECT_FALSE(key.type.empty()) << path;
  });
}

TEST(Schema, keys_name_their_unit) {
  for_each_key(scene_schema(), "", [](const Mapping&, const Key& key, const std::string& path) {
    if (key.info.unit == "degrees") {
      EXPECT_TRUE(key.key.ends_with("_deg")) << path;
    }
    if (key.info.unit == "nm") {
      EXPECT_TRUE(key.key.ends_with("_nm")) << path;
    }
  });
}

TEST(Schema, a_file_with_any_key_is_read) {
  for_each_key(scene_schema(), "", [](const Mapping&, const Key& key, const std::string& path) {
    if (key.below == nullptr) {
      EXPECT_EQ(errors_of(path, allowed_value(key)), "") << path;
    }
  });
}

TEST(Schema, every_required_key_is_missed) {
  for_each_key(scene_schema(), "", [](const Mapping& mapping, const Key& key, const std::string& path) {
    if (!key.info.required) return;
    const std::string text = errors_of(path, "(none)");
    EXPECT_NE(text.find("required key is missing"), std::string::npos) << path << " in " << mapping.keys.size();
  });
}

TEST(Schema, every_key_refuses_the_wrong_kind) {
  for_each_key(scene_schema(), "", [](const Mapping&, const Key& key, const std::string& path) {
    const bool takes_a_mapping = key.below != nullptr && !key.is_list;
    const std::string text = errors_of(path, takes_a_mapping ? "[1, 2]" : "{a: 1}");
    EXPECT_NE(text.find("error: " + path + ": expected "), std::string::npos) << path << "\n" << text;
  });
}

TEST(Schema, every_range_is_held_at_both_ends) {
  int ends = 0;
  for_each_key(scene_schema(), "", [&](const Mapping&, const Key& key, const std::string& path) {
    const Range& range = key.info.range;
    const bool vector = key.type == type_text(Of<math::Vec3d>{}, key.info);
    const bool pair = key.type == type_text(Of<Repeat>{}, key.info), points = key.key == "corners";
    const bool whole = key.type == type_text(Of<int>{}, {}) || range.low == range.high;
    const auto refuses = [&](double value, bool expected) {
      std::string text = format_number(value);
      if (whole) text = std::to_string(static_cast<long long>(value));
      const std::string written = vector   ? "[1, 2, " + text + "]"
                                  : pair   ? "[1, " + text + "]"
                                  : points ? "[[1, 2, " + text + "], [0, 1, 2], [7, 7, 8]]"
                                           : text;
      const std::string errors = errors_of(path, written);
      const std::string place = path + (vector ? "[2]" : pair ? "[1]" : points ? "[0][2]" : "") + ": expected ";
      EXPECT_EQ(errors.find(place) != std::string::npos, expected) << path << " = " << text << "\n" << errors;
      ++ends;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    if (range.has_low()) refuses(whole ? range.low - 1 : std::nextafter(range.low, -infinity), true);
    if (range.has_low()) refuses(range.low, range.low_open);
    if (range.has_high()) refuses(whole ? range.high + 1 : std::nextafter(range.high, infinity), true);
    if (range.has_high()) refuses(range.high, range.high_open);
  });
  EXPECT_GT(ends, 50);
}

TEST(Schema, every_number_has_a_range) {
  for_each_key(scene_schema(), "", [](const Mapping&, const Key& key, const std::string& path) {
    const bool number = key.type == type_text(Of<double>{}, {}) || key.type == type_text(Of<int>{}, {});
    if (number) {
      EXPECT_TRUE(key.info.range.has_low()) << path;
    }
  });
}

TEST(Schema, every_slip_is_answered_with_the_key) {
  for_each_key(scene_schema(), "", [](const Mapping& mapping, const Key& key, const std::string& path) {
    std::string slip(key.key);
    std::swap(slip[slip.size() / 2], slip[slip.size() / 2 - 1]);
    if (slip == key.key || mapping.find(slip) != nullptr) return;
    std::string file = file_with(scene_schema(), "", path, key.below ? "{}" : allowed_value(key));
    const std::string written = std::string(key.key) + ": ";
    // Only the key at `path` is misspelt; others of that name may stay right, so the last part alone is replaced.
    for (std::size_t at = file.find(written); at != std::string::npos; at = file.find(written, at + slip.size()))
      file.replace(at, key.key.size(), slip);
    const Result<SceneDesc> scene = read_scene(file, "test.yaml");
    ASSERT_FALSE(scene.ok()) << path;
    EXPECT_NE(to_text(scene.errors()).find("did you mean '" + std::string(key.key) + "'?"), std::string::npos)
        << path << "\n"
        << to_text(scene.errors());
  });
}

}  // namespace
}  // namespace shabon::scene
