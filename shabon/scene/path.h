// The way to a value in a scene file: objects[0].bubble.radius. A path refers to its parent, so that naming a value
// costs nothing until a problem is found there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shabon/io/yaml.h"

namespace shabon::scene {

struct Path {
  const Path* parent = nullptr;  // null at the root of the file
  std::string_view key = {};
  int index = -1;  // of an item of a list; -1 for a key

  std::string text() const;  // empty at the root
};

// A path that outlives its parents.
class KeptPath {
 public:
  explicit KeptPath(const Path& path);
  KeptPath(KeptPath&&) = default;
  KeptPath& operator=(KeptPath&&) = default;

  const Path& path() const { return steps_.back(); }

 private:
  std::vector<std::string> keys_;  // of the steps, which refer to them
  std::vector<Path> steps_;        // from the root
};

// The node the path leads to, or the innermost one on the way that exists: where a missing key belongs.
const io::YamlNode& nearest_node(const io::YamlNode& root, const Path& path);

}  // namespace shabon::scene
