#include "shabon/scene/path.h"

namespace shabon::scene {

namespace {

struct Found {
  const io::YamlNode* node;
  bool whole;  // the path was followed to its end
};

Found follow(const io::YamlNode& root, const Path& path) {
  if (path.parent == nullptr) return {&root, true};
  const Found above = follow(root, *path.parent);
  if (!above.whole) return above;
  if (path.index >= 0) {
    const auto index = static_cast<std::size_t>(path.index);
    const bool there = above.node->kind == io::YamlNode::Kind::sequence && index < above.node->items.size();
    return there ? Found{&above.node->items[index], true} : Found{above.node, false};
  }
  const bool mapping = above.node->kind == io::YamlNode::Kind::mapping;
  const io::YamlNode* value = mapping ? io::find(*above.node, path.key) : nullptr;
  return value != nullptr ? Found{value, true} : Found{above.node, false};
}

}  // namespace

std::string Path::text() const {
  if (parent == nullptr) return std::string(key);
  std::string result = parent->text();
  if (index >= 0) return result + "[" + std::to_string(index) + "]";
  if (!result.empty()) result += ".";
  return result + std::string(key);
}

KeptPath::KeptPath(const Path& path) {
  for (const Path* step = &path; step != nullptr; step = step->parent) steps_.insert(steps_.begin(), *step);
  for (const Path& step : steps_) keys_.emplace_back(step.key);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    steps_[i].parent = i == 0 ? nullptr : &steps_[i - 1];
    steps_[i].key = keys_[i];
  }
}

const io::YamlNode& nearest_node(const io::YamlNode& root, const Path& path) { return *follow(root, path).node; }

}  // namespace shabon::scene
