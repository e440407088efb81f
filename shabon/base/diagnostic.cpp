#include "shabon/base/diagnostic.h"

#include "shabon/base/text.h"

namespace shabon {

namespace {

// Long lines (a hostile or machine-written file) are cut to a window around the caret.
constexpr std::size_t window_characters = 100;

std::string excerpt_with_caret(const Diagnostic& diagnostic) {
  const std::size_t caret = diagnostic.column > 0 ? static_cast<std::size_t>(diagnostic.column - 1) : 0;
  std::vector<std::string> characters = utf8_characters(diagnostic.excerpt);
  std::size_t first = 0;
  if (characters.size() > window_characters && caret > window_characters / 2) first = caret - window_characters / 2;
  std::string line, below;
  for (std::size_t i = first; i < characters.size() && i < first + window_characters; ++i) {
    const bool printable = characters[i].size() > 1 || static_cast<unsigned char>(characters[i][0]) >= 0x20;
    const bool tab = characters[i] == "\t";
    line += tab ? " " : printable ? characters[i] : "?";
    if (i < caret) below += ' ';
  }
  return "    " + line + "\n    " + below + "^";
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  std::string text;
  if (!diagnostic.source.empty()) {
    text += printable(diagnostic.source);
    if (diagnostic.line > 0) {
      text += ":" + std::to_string(diagnostic.line);
      if (diagnostic.column > 0) text += ":" + std::to_string(diagnostic.column);
    }
    text += ": ";
  }
  text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
  if (!diagnostic.key.empty()) text += printable(diagnostic.key) + ": ";
  text += printable(diagnostic.message);
  if (diagnostic.line > 0 && diagnostic.column > 0 && !diagnostic.excerpt.empty())
    text += "\n" + excerpt_with_caret(diagnostic);
  return text;
}

std::string to_text(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic) + "\n";
  return text;
}

}  // namespace shabon
