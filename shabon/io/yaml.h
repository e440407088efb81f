// YAML (and with it JSON) as a tree of text in which every node knows its place. What the text means is the reader's
// business: nothing here turns "1e3" or "yes" into a value unless asked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/io/file.h"

namespace shabon::io {

struct YamlEntry;

struct YamlNode {
  enum class Kind { scalar, sequence, mapping, null };
  Kind kind = Kind::null;
  std::string text;                // of a scalar, escapes resolved
  bool quoted = false;             // written in quotes, as a block scalar or with !!str: text, never a number
  int line = 0;                    // counted from 1
  int column = 0;                  // counted from 1, in characters
  std::vector<YamlNode> items;     // of a sequence
  std::vector<YamlEntry> entries;  // of a mapping, in file order; keys are scalars, all different
};

// A key and its value. Not a std::pair, which some compilers refuse to form of a type that is being defined.
struct YamlEntry {
  YamlNode first, second;
};

struct YamlDocument {
  std::string source;              // the name given to parse_yaml
  std::vector<std::string> lines;  // without line ends, for excerpts
  YamlNode root;
};

inline constexpr std::size_t yaml_max_bytes = 16 << 20;
inline constexpr std::size_t yaml_max_depth = 64;         // sequences and mappings within each other
inline constexpr std::size_t yaml_max_nodes = 1'000'000;  // after aliases are expanded

// One document with its aliases expanded; an expanded node keeps the place of its anchor. Errors (Failure::content,
// each with line, column and excerpt): everything YAML itself forbids, and also duplicate keys, keys that are not
// scalars, the merge key `<<`, aliases that contain themselves, a second document, tags beyond the core ones (!!str,
// !!int,
// !!float, !!bool, !!null, !!seq, !!map), bytes that are not UTF-8, control characters, an empty document, and
// anything above the limits. As many as can be told apart are reported at once.
Result<YamlDocument> parse_yaml(std::string_view text, std::string source);

// The same, but what leaves the rest of the document readable is added to `flaws` instead, so that a reader can report
// it together with its own findings: duplicate keys (the first one counts), keys that are not scalars and merge keys
// (left out), other tags (ignored), aliases that contain themselves (empty). A document with flaws must not be used.
Result<YamlDocument> parse_yaml(std::string_view text, std::string source, Diagnostics& flaws);

// read_text_file and parse_yaml.
Result<YamlDocument> read_yaml(const std::filesystem::path& path);

// The value of a mapping's key (exact spelling), or nullptr.
const YamlNode* find(const YamlNode& mapping, std::string_view key);

// "a number", "a list", ...: for "expected ..., got ...". Scalars show their text.
std::string describe(const YamlNode& node);

// An error of Failure::content that points at `node`; `key` is the dotted path shown before the message.
Diagnostic diagnostic_at(const YamlDocument& document, const YamlNode& node, std::string message, std::string key = {});

// What the node says, or "expected ..., got ..." at its place. A quoted scalar is text, never a number or a truth
// value; nan and inf in any spelling are errors, as are numbers too large for a double.
Result<double> as_number(const YamlDocument& document, const YamlNode& node, std::string key = {});
Result<long long> as_integer(const YamlDocument& document, const YamlNode& node, std::string key = {});
Result<bool> as_bool(const YamlDocument& document, const YamlNode& node, std::string key = {});         // true or false
Result<std::string> as_text(const YamlDocument& document, const YamlNode& node, std::string key = {});  // any scalar

}  // namespace shabon::io
