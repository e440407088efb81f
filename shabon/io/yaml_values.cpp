// What a YAML node says when it is asked for a number, a truth value or text.
#include "shabon/base/text.h"
#include "shabon/io/text_lines.h"
#include "shabon/io/yaml.h"

namespace shabon::io {

namespace {

constexpr std::size_t longest_shown = 60;

Diagnostics expected(const YamlDocument& document, const YamlNode& node, std::string key, const std::string& what) {
  return {diagnostic_at(document, node, "expected " + what + ", got " + describe(node), std::move(key))};
}

bool is_plain(const YamlNode& node) { return node.kind == YamlNode::Kind::scalar && !node.quoted; }

}  // namespace

const YamlNode* find(const YamlNode& mapping, std::string_view key) {
  for (const auto& [name, value] : mapping.entries)
    if (name.text == key) return &value;
  return nullptr;
}

std::string describe(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::scalar:
      return node.quoted ? "the text \"" + printable(node.text, longest_shown) + "\""
                         : printable(node.text, longest_shown);
    case YamlNode::Kind::sequence:
      return "a list";
    case YamlNode::Kind::mapping:
      return "a mapping";
    case YamlNode::Kind::null:
      break;
  }
  return "nothing";
}

Diagnostic diagnostic_at(const YamlDocument& document, const YamlNode& node, std::string message, std::string key) {
  return diagnostic_at(document.source, document.lines, node.line, node.column, std::move(message), std::move(key));
}

Result<double> as_number(const YamlDocument& document, const YamlNode& node, std::string key) {
  if (is_plain(node))
    if (const auto number = parse_number(node.text)) return *number;
  return expected(document, node, std::move(key), "a number");
}

Result<long long> as_integer(const YamlDocument& document, const YamlNode& node, std::string key) {
  if (is_plain(node))
    if (const auto number = parse_integer(node.text)) return *number;
  return expected(document, node, std::move(key), "a whole number");
}

Result<bool> as_bool(const YamlDocument& document, const YamlNode& node, std::string key) {
  if (is_plain(node)) {
    if (node.text == "true" || node.text == "True" || node.text == "TRUE") return true;
    if (node.text == "false" || node.text == "False" || node.text == "FALSE") return false;
  }
  return expected(document, node, std::move(key), "true or false");
}

Result<std::string> as_text(const YamlDocument& document, const YamlNode& node, std::string key) {
  if (node.kind == YamlNode::Kind::scalar) return node.text;
  return expected(document, node, std::move(key), "text");
}

}  // namespace shabon::io
