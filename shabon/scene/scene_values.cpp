#include "shabon/scene/scene_values.h"

#include "shabon/io/yaml.h"
#include "shabon/scene/override.h"

namespace shabon::scene {

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

void list(const io::YamlNode& node, const std::string& path, Values& values) {
  using Kind = io::YamlNode::Kind;
  switch (node.kind) {
    case Kind::scalar:
      values.emplace_back(path, node.text);
      return;
    case Kind::null:
      values.emplace_back(path, "null");
      return;
    case Kind::sequence:
      if (node.items.empty()) values.emplace_back(path, "[]");
      for (std::size_t i = 0; i < node.items.size(); ++i)
        list(node.items[i], path + "[" + std::to_string(i) + "]", values);
      return;
    case Kind::mapping:
      if (node.entries.empty()) values.emplace_back(path, "{}");
      for (const auto& [key, value] : node.entries)
        list(value, path.empty() ? key.text : path + "." + key.text, values);
      return;
  }
}

}  // namespace

Result<Values> scene_values(std::string_view text, std::string source, std::span<const std::string> overrides) {
  Diagnostics flaws;  // told when the scene is read
  Result<io::YamlDocument> document = io::parse_yaml(text, std::move(source), flaws);
  if (!document) return document.errors();
  for (const std::string& assignment : overrides)
    if (const Status set = apply_override(*document, assignment); !set) return set.errors();
  Values values;
  list(document->root, "", values);
  return values;
}

}  // namespace shabon::scene
