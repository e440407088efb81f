#include "shabon/io/yaml_tree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <yaml-cpp/exceptions.h>

#include "shabon/base/text.h"
#include "shabon/io/text_lines.h"

namespace shabon::io {

namespace {

constexpr std::size_t most_errors = 100;
constexpr std::size_t most_text_bytes = 4 * yaml_max_bytes;  // of all scalars, aliases expanded

constexpr std::string_view core_tag_prefix = "tag:yaml.org,2002:";

bool is_continuation(char c) { return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80; }

// The core tag's short name; "" without a tag ("?" and "!" are yaml-cpp's words for that); nothing for another tag.
std::optional<std::string_view> core_tag(std::string_view tag) {
  if (tag.empty() || tag == "?" || tag == "!") return "";
  if (tag.starts_with(core_tag_prefix)) {
    tag.remove_prefix(core_tag_prefix.size());
    for (std::string_view known : {"str", "int", "float", "bool", "null", "seq", "map"})
      if (tag == known) return known;
  }
  return {};
}

std::string unsupported_tag(std::string_view tag) { return "tag '" + printable(tag, 60) + "' is not supported here"; }

bool is_null_text(std::string_view text) { return text.empty() || text == "~" || same_name(text, "null"); }

}  // namespace

void YamlPlaces::locate(const YAML::Mark& mark, int& line, int& column) {
  const auto at_line = static_cast<std::size_t>(std::max(mark.line, 0));
  const auto at_byte = static_cast<std::size_t>(std::max(mark.column, 0));
  if (at_line != line_) {
    line_ = at_line;
    byte_ = character_ = 0;
  }
  const std::string_view text = line_ < lines_.size() ? std::string_view(lines_[line_]) : std::string_view();
  const std::size_t target = std::min(at_byte, text.size());
  for (; byte_ < target; ++byte_) character_ += !is_continuation(text[byte_]);
  for (; byte_ > target; --byte_) character_ -= !is_continuation(text[byte_ - 1]);
  line = static_cast<int>(line_) + 1;
  column = static_cast<int>(character_) + 1;
}

void YamlTreeBuilder::Size::contain(const Size& inner) {
  nodes += inner.nodes;
  text_bytes += inner.text_bytes;
  depth = std::max(depth, inner.depth + 1);
}

void YamlTreeBuilder::syntax_error(const YAML::Mark& mark, const std::string& problem) {
  int line = 0, column = 0;
  places_.locate(mark, line, column);
  const bool at_end = mark.column == 0 && static_cast<std::size_t>(line) >= lines_.size();
  const bool bracket = problem == YAML::ErrorMsg::END_OF_SEQ_FLOW || problem == YAML::ErrorMsg::END_OF_MAP_FLOW;
  if (problem == YAML::ErrorMsg::UNKNOWN_ANCHOR) {
    error_at(line, column, "unknown alias: no anchor of this name comes before it");
  } else if (bracket && at_end && !frames_.empty()) {
    const YamlNode& open_node = frames_.back().node;  // where it begins says more than where the file ends
    const std::string closing = open_node.kind == YamlNode::Kind::sequence ? "']'" : "'}'";
    error_at(open_node.line, open_node.column, "not valid YAML: the closing " + closing + " is missing");
  } else {
    error_at(line, column, "not valid YAML: " + problem);
  }
}

void YamlTreeBuilder::error_at(int line, int column, std::string message) {
  errors_.push_back(diagnostic_at(source_, lines_, line, column, std::move(message)));
  if (errors_.size() >= most_errors) throw YamlStop();
}

void YamlTreeBuilder::stop_at(int line, int column, std::string message) {
  error_at(line, column, std::move(message));
  throw YamlStop();
}

YamlNode YamlTreeBuilder::make(const YAML::Mark& mark, YamlNode::Kind kind) {
  YamlNode node;
  node.kind = kind;
  places_.locate(mark, node.line, node.column);
  return node;
}

void YamlTreeBuilder::count(const Size& size, int line, int column) {
  total_.nodes += size.nodes;
  total_.text_bytes += size.text_bytes;
  if (total_.nodes > yaml_max_nodes)
    stop_at(line, column,
            "more than " + std::to_string(yaml_max_nodes) + " values (aliases count as what they repeat)");
  if (total_.text_bytes > most_text_bytes) stop_at(line, column, "aliases repeat too much text");
  if (frames_.size() + size.depth > yaml_max_depth)
    stop_at(line, column, "nested more than " + std::to_string(yaml_max_depth) + " deep");
}

void YamlTreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (++documents_ == 1) return;
  int line = 0, column = 0;
  places_.locate(mark, line, column);
  const auto index = static_cast<std::size_t>(line) - 1;
  const bool marked = column == 1 && index < lines_.size() && lines_[index].starts_with("---");
  stop_at(line, column, marked ? "a second document begins; expected one only" : "text after the end of the document");
}

void YamlTreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  YamlNode node = make(mark, YamlNode::Kind::null);
  // yaml-cpp places a value that is missing at whatever follows it; its key says more.
  if (!frames_.empty() && frames_.back().key && frames_.back().key->line < node.line) {
    node.line = frames_.back().key->line;
    node.column = frames_.back().key->column;
  }
  count({}, node.line, node.column);
  remember(anchor, node, {});
  attach(std::move(node), {});
}

void YamlTreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                               const std::string& value) {
  YamlNode node = make(mark, YamlNode::Kind::scalar);
  const auto core = core_tag(tag);
  if (!core || *core == "seq" || *core == "map" || (*core == "null" && !is_null_text(value)))
    error_at(node.line, node.column, unsupported_tag(tag));
  if (core == "null") {
    node.kind = YamlNode::Kind::null;
  } else {
    node.text = value;
    node.quoted = tag == "!" || core == "str";
  }
  const Size size{1, value.size(), 0};
  count(size, node.line, node.column);
  remember(anchor, node, size);
  attach(std::move(node), size);
}

void YamlTreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  int line = 0, column = 0;
  places_.locate(mark, line, column);
  const auto found = anchors_.find(anchor);
  if (found == anchors_.end()) {
    error_at(line, column, "an alias inside the value it stands for");
    attach(make(mark, YamlNode::Kind::null), {});
    return;
  }
  count(found->second.size, line, column);
  attach(found->second.node, found->second.size);
}

void YamlTreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                                      YAML::EmitterStyle::value) {
  open(mark, tag, anchor, YamlNode::Kind::sequence);
}

void YamlTreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                                 YAML::EmitterStyle::value) {
  open(mark, tag, anchor, YamlNode::Kind::mapping);
}

void YamlTreeBuilder::open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
  Frame frame;
  frame.node = make(mark, kind);
  frame.anchor = anchor;
  frame.size.depth = 1;
  const auto core = core_tag(tag);
  if (!core || (!core->empty() && *core != (kind == YamlNode::Kind::sequence ? "seq" : "map")))
    error_at(frame.node.line, frame.node.column, unsupported_tag(tag));
  count(frame.size, frame.node.line, frame.node.column);
  frames_.push_back(std::move(frame));
}

void YamlTreeBuilder::close() {
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  remember(frame.anchor, frame.node, frame.size);
  attach(std::move(frame.node), frame.size);
}

// Anchors within anchors are kept once per level, so they have a bound of their own.
void YamlTreeBuilder::remember(YAML::anchor_t anchor, const YamlNode& node, const Size& size) {
  if (anchor == 0) return;
  anchored_nodes_ += size.nodes;
  if (anchored_nodes_ > yaml_max_nodes)
    stop_at(node.line, node.column, "anchors hold more than " + std::to_string(yaml_max_nodes) + " values");
  anchors_.emplace(anchor, Anchored{node, size});
}

void YamlTreeBuilder::attach(YamlNode node, const Size& size) {
  if (frames_.empty()) {
    root_ = std::move(node);
    return;
  }
  Frame& frame = frames_.back();
  frame.size.contain(size);
  if (frame.node.kind == YamlNode::Kind::sequence) {
    frame.node.items.push_back(std::move(node));
  } else if (!frame.key) {
    take_key(frame, std::move(node));
  } else {
    if (frame.key_usable) frame.node.entries.push_back({std::move(*frame.key), std::move(node)});
    frame.key.reset();
  }
}

void YamlTreeBuilder::take_key(Frame& frame, YamlNode node) {
  frame.key_usable = false;
  if (node.kind != YamlNode::Kind::scalar) {
    error_at(node.line, node.column, "a key must be text, got " + describe(node));
  } else if (node.text == "<<" && !node.quoted) {
    error_at(node.line, node.column, "the merge key '<<' is not supported; write the keys out");
  } else if (const auto [first, is_new] = frame.key_lines.emplace(node.text, node.line); !is_new) {
    error_at(node.line, node.column,
             "duplicate key '" + printable(node.text, 60) + "', first on line " + std::to_string(first->second));
  } else {
    frame.key_usable = true;
  }
  frame.key = std::move(node);
}

}  // namespace shabon::io
