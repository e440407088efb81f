#include "shabon/scene/reference_table.h"

#include "shabon/base/text.h"
#include "shabon/scene/schema.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

std::string cell(const std::string& text) {
  std::string escaped;
  for (char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string value_cell(const Key& key) {
  std::string text = key.type;
  if (key.info.names != nullptr) {
    text = "one of ";
    for (std::string_view name : key.info.names()) text += (text.back() == ' ' ? "" : ", ") + std::string(name);
  }
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

// The tables: first that of the whole file, then one for each mapping with a section of its own, as they are met.
class Tables {
 public:
  std::string text() {
    std::string result = table_of(scene_schema());
    for (std::size_t i = 0; i < sections_.size(); ++i)
      result += "\n### " + std::string(sections_[i]->section) + "\n\n" + table_of(*sections_[i]);
    return result;
  }

 private:
  std::string table_of(const Mapping& mapping) {
    std::string table = "| key | value | default | meaning |\n|---|---|---|---|\n";
    add_rows(mapping, "", table);
    return table;
  }

  void add_rows(const Mapping& mapping, const std::string& above, std::string& table) {
    for (const Key& key : mapping.keys) {
      const std::string path = above + (above.empty() ? "" : ".") + std::string(key.key) + (key.is_list ? "[]" : "");
      const Mapping* below = key.below == nullptr ? nullptr : &key.below();
      const bool elsewhere = below != nullptr && !below->section.empty();
      table += "| `" + path + "` | " + cell(elsewhere ? link_cell(key, *below) : value_cell(key)) + " | " +
               cell(default_cell(mapping, key)) + " | " + cell(std::string(key.info.doc)) + " |\n";
      if (elsewhere)
        remember(*below);
      else if (below != nullptr)
        add_rows(*below, path, table);
    }
  }

  static std::string link_cell(const Key& key, const Mapping& below) {
    std::string anchor(below.section);
    for (char& c : anchor)
      if (c == ' ') c = '-';
    return key.type + ": [" + std::string(below.section) + "](#" + anchor + ")";
  }

  void remember(const Mapping& mapping) {
    for (const Mapping* known : sections_)
      if (known == &mapping) return;
    sections_.push_back(&mapping);
  }

  std::vector<const Mapping*> sections_;
};

}  // namespace

std::string reference_table() { return Tables().text(); }

}  // namespace shabon::scene
