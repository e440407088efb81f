#include "shabon/io/yaml.h"

#include <new>
#include <optional>
#include <sstream>

#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "shabon/base/text.h"
#include "shabon/io/text_lines.h"
#include "shabon/io/yaml_tree.h"

namespace shabon::io {

namespace {

// yaml-cpp keeps every token of a bracket in memory until it closes. A document of yaml_max_nodes values needs fewer
// brackets and commas than this; a hostile file has more.
constexpr std::size_t most_brackets_and_commas = 3 * yaml_max_nodes;

std::optional<TextDefect> find_too_many_tokens(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (std::string_view("[]{},").find(text[i]) != std::string_view::npos && ++count > most_brackets_and_commas)
      return TextDefect{i, "more than " + std::to_string(most_brackets_and_commas) + " brackets and commas"};
  return {};
}

// Feeds the builder; what yaml-cpp cannot parse becomes one of its errors. Returns whether it came to the end.
bool build(const std::string& text, YamlTreeBuilder& builder) {
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return true;
  } catch (const YAML::Exception& problem) {
    try {
      builder.syntax_error(problem.mark, problem.msg);
    } catch (const YamlStop&) {
    }
  } catch (const YamlStop&) {
  }
  return false;
}

Diagnostics without_place(const std::string& source, Failure failure, std::string message) {
  Diagnostics errors = fail(failure, std::move(message));
  errors[0].source = source;
  return errors;
}

}  // namespace

Result<YamlDocument> parse_yaml(std::string_view text, std::string source) {
  Diagnostics flaws;
  Result<YamlDocument> document = parse_yaml(text, std::move(source), flaws);
  if (!flaws.empty()) return flaws;
  return document;
}

Result<YamlDocument> parse_yaml(std::string_view text, std::string source, Diagnostics& flaws) try {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.size() > yaml_max_bytes)
    return without_place(source, Failure::content, "larger than " + std::to_string(yaml_max_bytes) + " bytes");
  if (const auto defect = find_text_defect(text)) return Diagnostics{to_diagnostic(source, text, *defect)};
  if (const auto defect = find_too_many_tokens(text)) return Diagnostics{to_diagnostic(source, text, *defect)};
  const std::string plain = with_plain_line_ends(text);
  YamlDocument document{std::move(source), split_lines(plain), {}};
  YamlTreeBuilder builder(document.source, document.lines);
  if (!build(plain, builder)) return builder.errors();
  flaws.insert(flaws.end(), builder.errors().begin(), builder.errors().end());
  document.root = std::move(builder.root());
  if (document.root.kind == YamlNode::Kind::null)
    return Diagnostics{diagnostic_at(document.source, document.lines, 1, 1, "the document is empty")};
  return document;
} catch (const std::bad_alloc&) {
  return without_place({}, Failure::content, "not enough memory for this document");
} catch (const std::exception& problem) {
  return without_place({}, Failure::internal, std::string("reading YAML: ") + problem.what());
}

Result<YamlDocument> read_yaml(const std::filesystem::path& path) {
  const Result<std::string> text = read_text_file(path, yaml_max_bytes);
  if (!text) return text.errors();
  return parse_yaml(*text, path.string());
}

}  // namespace shabon::io
