#include "shabon/scene/schema.h"

#include "shabon/base/text.h"

namespace shabon::scene {

namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

std::string joined(const std::vector<std::string>& parts, std::string_view last_word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " " + std::string(last_word) + " " : ", ";
    text += parts[i];
  }
  return text;
}

std::string missing_message(const std::string& expected) { return "required key is missing; expected " + expected; }

// The key an unknown name may be a slip of.
const Key* meant_by(std::string_view name, const Mapping& mapping) {
  const auto nearest = nearest_name(name, mapping.key_names());
  return nearest ? mapping.find(*nearest) : nullptr;
}

bool has_common_keys(const Mapping& mapping) {
  for (const Key& key : mapping.keys)
    if (key.choice == Key::common) return true;
  return false;
}

}  // namespace

const Key* Mapping::find(std::string_view key) const {
  for (const Key& candidate : keys)
    if (candidate.key == key) return &candidate;
  return nullptr;
}

std::vector<std::string_view> Mapping::key_names() const {
  std::vector<std::string_view> names;
  for (const Key& key : keys) names.push_back(key.key);
  return names;
}

std::string Mapping::names_of_choice(int choice) const {
  std::vector<std::string> names;
  for (const Key& key : keys)
    if (key.choice == choice && key.info.required) names.push_back(quoted(key.key));
  return joined(names, "and");
}

std::string Mapping::names_of_choices() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < choices.size(); ++i) names.push_back(names_of_choice(static_cast<int>(i)));
  return joined(names, "or");
}

void read_mapping(const Mapping& mapping, const io::YamlNode& node, const Path& path, void* object,
                  Problems& problems) {
  if (node.kind != io::YamlNode::Kind::mapping) {
    problems.add(node, path, "expected a mapping with keys, got " + io::describe(node));
    return;
  }
  if (mapping.begin) mapping.begin(node, object);
  int chosen = Key::common;
  bool choice_given = mapping.choices.empty();
  std::string_view chosen_key;
  std::vector<bool> present(mapping.keys.size(), false);
  for (const auto& [name, value] : node.entries) {
    if (problems.full()) return;
    const Path below{&path, name.text};
    const Key* key = mapping.find(name.text);
    if (key == nullptr) {
      problems.add(name, below, unknown_name("key", name.text, mapping.key_names()));
      // What the slip stands for is not missing, nor is the choice where nothing but a choice can stand.
      const Key* meant = meant_by(name.text, mapping);
      if (meant != nullptr) present[static_cast<std::size_t>(meant - mapping.keys.data())] = true;
      choice_given |= !has_common_keys(mapping) || (meant != nullptr && meant->choice != Key::common);
      continue;
    }
    if (key->choice != Key::common) {
      if (chosen == Key::common) {
        chosen = key->choice;
        chosen_key = key->key;
        choice_given = true;
        mapping.choose(object, chosen);
      } else if (chosen != key->choice) {
        problems.add(
            name, below,
            "cannot stand beside " + quoted(chosen_key) + "; expected only one of " + mapping.names_of_choices());
        continue;
      }
    }
    present[static_cast<std::size_t>(key - mapping.keys.data())] = true;
    key->read(value, below, object, problems);
  }
  for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
    const Key& key = mapping.keys[i];
    const bool wanted = key.choice == Key::common || key.choice == chosen;
    if (key.info.required && wanted && !present[i]) problems.add(node, Path{&path, key.key}, missing_message(key.type));
  }
  if (!choice_given) problems.add(node, path, missing_message(mapping.names_of_choices()));
}

void check_length(std::size_t length, const FieldInfo& info, const Path& path, Problems& problems) {
  const auto expected = static_cast<std::size_t>(info.items);
  if (expected > 0 && length != expected && !problems.has(path))
    problems.add(path, "expected " + std::to_string(expected) + " items, got " + std::to_string(length));
}

void check_mapping(const Mapping& mapping, const void* object, const Path& path, Problems& problems) {
  const int chosen = mapping.choices.empty() ? Key::common : mapping.chosen(object);
  for (const Key& key : mapping.keys) {
    if (problems.full()) return;
    if (key.choice == Key::common || key.choice == chosen) key.check(object, Path{&path, key.key}, problems);
  }
  for (const auto& rule : mapping.rules) rule(object, path, problems);
}

}  // namespace shabon::scene
