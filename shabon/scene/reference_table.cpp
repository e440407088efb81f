#include "shabon/scene/reference_table.h"

#include "shabon/base/text.h"
#include "shabon/scene/schema.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

std::string cell(std::string text) {
  std::string escaped;
  for (char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string value_cell(const Key& key) {
  std::string text = key.type;
  const std::string range = range_text(key.info);
  return range.empty() || range == text ? text : text + ", " + range;
}

std::string default_cell(const Mapping& mapping, const Key& key) {
  if (key.choice != Key::common && key.info.required) {
    const bool only = mapping.choices.size() == 1;
    return only ? "required" : "one of " + mapping.names_of_choices();
  }
  if (key.info.required) return "required";
  return key.initial.empty() ? "of its keys" : key.initial;
}

void add_rows(const Mapping& mapping, const std::string& above, std::string& table) {
  for (const Key& key : mapping.keys) {
    const std::string path = above + (above.empty() ? "" : ".") + std::string(key.key) + (key.is_list ? "[]" : "");
    table += "| `" + path + "` | " + cell(value_cell(key)) + " | " + cell(default_cell(mapping, key)) + " | " +
             cell(std::string(key.info.doc)) + " |\n";
    if (key.below != nullptr) add_rows(*key.below, path, table);
  }
}

}  // namespace

std::string reference_table() {
  std::string table = "| key | value | default | meaning |\n|---|---|---|---|\n";
  add_rows(scene_schema(), "", table);
  return table;
}

}  // namespace shabon::scene
