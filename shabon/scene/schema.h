// What a scene file may hold, as a tree that the reader, the checks, `--set` and the reference table walk alike. The
// tree is built from the field lists of the description (schema_fields.h) by schema_build.h; nothing is listed twice.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"

namespace shabon::scene {

struct Mapping;

// One key of a mapping. `object` always is the struct the mapping describes, without its type.
struct Key {
  static constexpr int common = -1;

  std::string_view key;
  FieldInfo info;
  std::string type;     // "number", "[x, y, z]", "list of mappings", ...
  std::string initial;  // the default as it would be written, or empty
  int choice = common;  // index into Mapping::choices when the key belongs to only one of them
  // Of a mapping, or of the items of a list of mappings. A function, as a mapping may stand below itself.
  const Mapping& (*below)() = nullptr;
  bool is_list = false;

  // Turns the node into the member; what cannot be understood is a problem and leaves the member alone.
  std::function<void(const io::YamlNode&, const Path&, void* object, Problems&)> read;
  // Checks the member's value against its range, its names and the rules of what it holds.
  std::function<void(const void* object, const Path&, Problems&)> check;
};

// Keys of one struct. With choices (a std::variant), a mapping must hold keys of exactly one of them.
struct Mapping {
  std::vector<Key> keys;
  std::string_view section;  // heading of its own table in the reference, or empty
  std::vector<About> choices;
  std::function<void(void* object, int choice)> choose;          // makes the variant hold that choice
  std::function<int(const void* object)> chosen;                 // which one it holds
  std::function<void(const io::YamlNode&, void* object)> begin;  // sets defaults that depend on the mapping, or empty
  std::vector<std::function<void(const void* object, const Path&, Problems&)>> rules;  // between several members

  const Key* find(std::string_view key) const;
  std::vector<std::string_view> key_names() const;
  // The keys of one choice as "'medium' and 'thickness'", of all as "'constant', 'gradient' or 'image'".
  std::string names_of_choice(int choice) const;
  std::string names_of_choices() const;
};

// The mapping at the root of a scene file.
const Mapping& scene_schema();

void read_mapping(const Mapping& mapping, const io::YamlNode& node, const Path& path, void* object, Problems& problems);
void check_mapping(const Mapping& mapping, const void* object, const Path& path, Problems& problems);

// Whether a list has as many items as its field asks for.
void check_length(std::size_t length, const FieldInfo& info, const Path& path, Problems& problems);

}  // namespace shabon::scene
