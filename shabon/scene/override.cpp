#include "shabon/scene/override.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/schema.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

using io::YamlNode;

// A part of a path: a key, or an index in brackets.
struct Step {
  std::string_view key;
  std::optional<std::size_t> index;
};

Diagnostics refuse(std::string_view path, std::string message, Failure failure = Failure::content) {
  Diagnostics errors = fail(failure, std::move(message));
  errors.front().source = override_source;
  errors.front().key = path;
  return errors;
}

// "objects[0].bubble" as three steps; nothing when it is not written so.
std::optional<std::vector<Step>> steps_of(std::string_view path) {
  std::vector<Step> steps;
  for (std::string_view part : split(path, '.')) {
    std::size_t bracket = std::min(part.find('['), part.size());
    if (bracket == 0) return {};
    steps.push_back({part.substr(0, bracket), {}});
    while (bracket < part.size()) {
      const std::size_t end = part.find(']', bracket);
      if (part[bracket] != '[' || end == std::string_view::npos) return {};
      const std::string_view digits = part.substr(bracket + 1, end - bracket - 1);
      const auto index = parse_integer(digits);
      if (!index || *index < 0 || digits.front() == '+') return {};
      steps.push_back({{}, static_cast<std::size_t>(*index)});
      bracket = end + 1;
    }
  }
  return steps;
}

// Line 0 is what marks a node as set from outside the file.
void forget_places(YamlNode& node) {
  node.line = node.column = 0;
  for (YamlNode& item : node.items) forget_places(item);
  for (auto& [key, value] : node.entries) {
    forget_places(key);
    forget_places(value);
  }
}

YamlNode new_scalar(std::string_view text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.text = text;
  return node;
}

// The value of `key` in the mapping `node`, added when it is not there. Keys of other choices give way.
YamlNode& entry_of(YamlNode& node, const Mapping& mapping, const Key& key) {
  if (node.kind == YamlNode::Kind::null) node.kind = YamlNode::Kind::mapping;
  auto& entries = node.entries;
  if (key.choice != Key::common)
    entries.erase(std::remove_if(entries.begin(), entries.end(),
                                 [&](const auto& entry) {
                                   const Key* other = mapping.find(entry.first.text);
                                   return other && other->choice != Key::common && other->choice != key.choice;
                                 }),
                  entries.end());
  for (auto& [name, value] : entries)
    if (name.text == key.key) return value;
  entries.push_back({new_scalar(key.key), YamlNode()});
  return entries.back().second;
}

// Whether one item of a plain value may be set.
bool is_vector(const Key& key) {
  return key.type == type_text(Of<math::Vec3d>{}, {}) || key.type == type_text(Of<Repeat>{}, {}) ||
         key.type == type_text(Of<ColorDesc>{}, {});
}

// Follows the path down the document and its schema side by side.
class Walk {
 public:
  Walk(std::string_view path, const io::YamlDocument& document, YamlNode& root, const Mapping& mapping)
      : path_(path), document_(document), node_(&root), mapping_(&mapping) {}

  Status take(const Step& step) { return step.index ? take_index(*step.index) : take_key(step.key); }
  YamlNode& node() { return *node_; }

 private:
  Status take_key(std::string_view name) {
    if (mapping_ == nullptr || expects_index_)
      return refuse(path_, "'" + printable(name, 60) + "' leads nowhere: " + described() + " has " +
                               (expects_index_ ? "items [0], [1], ..." : "no keys"));
    const Key* key = mapping_->find(name);
    if (key == nullptr) return refuse(path_, unknown_name("key", name, mapping_->key_names()));
    if (node_->kind != YamlNode::Kind::mapping && node_->kind != YamlNode::Kind::null)
      return wrong_above("a mapping with keys");
    node_ = &entry_of(*node_, *mapping_, *key);
    mapping_ = key->below == nullptr ? nullptr : &key->below();
    described_ = name;
    expects_index_ = key->is_list;
    holds_items_ = key->is_list || is_vector(*key) ? key->type : "";
    walked_ += (walked_.empty() ? "" : ".") + std::string(name);
    return Done{};
  }

  Status take_index(std::size_t index) {
    const bool other_kind = node_->kind != YamlNode::Kind::sequence && node_->kind != YamlNode::Kind::null;
    if (other_kind && !holds_items_.empty()) return wrong_above(holds_items_);
    if (node_->kind != YamlNode::Kind::sequence)
      return refuse(path_, described() + " is not a list in the file; expected it to be set whole");
    if (index >= node_->items.size())
      return refuse(path_, "expected an index below " + std::to_string(node_->items.size()) + " in " + described() +
                               ", got " + std::to_string(index));
    node_ = &node_->items[index];
    expects_index_ = false;
    holds_items_.clear();
    described_ += "[" + std::to_string(index) + "]";
    walked_ += "[" + std::to_string(index) + "]";
    return Done{};
  }

  // The fault is not the path's: what stands above is wrong, and is told where it stands, as the reader does.
  Status wrong_above(const std::string& expected) const {
    Diagnostics errors{
        io::diagnostic_at(document_, *node_, "expected " + expected + ", got " + io::describe(*node_), walked_)};
    if (node_->line == 0) errors.front().source = override_source;
    return errors;
  }

  std::string described() const { return "'" + described_ + "'"; }

  std::string_view path_;
  const io::YamlDocument& document_;
  YamlNode* node_;
  const Mapping* mapping_;  // of the node; null below a plain value
  bool expects_index_ = false;
  std::string holds_items_;  // what the node is called when an index may follow, such as "a list"
  std::string described_;    // the last key with its index
  std::string walked_;       // the path as far as it was followed
};

}  // namespace

Status set_value(io::YamlDocument& document, std::string_view path, std::string_view value, const Mapping& mapping) {
  const auto steps = steps_of(path);
  if (!steps) return refuse(path, "expected a path such as objects[0].bubble.radius", Failure::usage);
  if (trim(value).empty()) return refuse(path, "expected a value, got an empty text", Failure::usage);
  // A comment is no value: what begins like one is a colour.
  const std::string text = trim(value).front() == '#' ? "'" + std::string(trim(value)) + "'" : std::string(value);
  Result<io::YamlDocument> parsed = io::parse_yaml(text, std::string(override_source));
  if (!parsed) {
    Diagnostics errors = parsed.errors();
    for (Diagnostic& error : errors) error.key = path;
    return errors;
  }
  YamlNode root = document.root;
  Walk walk(path, document, root, mapping);
  for (const Step& step : *steps)
    if (Status taken = walk.take(step); !taken) return taken;
  walk.node() = std::move(parsed->root);
  forget_places(walk.node());
  document.root = std::move(root);
  return Done{};
}

Status apply_override(io::YamlDocument& document, std::string_view assignment, const Mapping& root) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return refuse("",
                  "expected path=value, such as objects[0].bubble.radius=2, got '" + printable(assignment, 60) + "'",
                  Failure::usage);
  return set_value(document, trim(assignment.substr(0, equals)), assignment.substr(equals + 1), root);
}

}  // namespace shabon::scene
