#include "shabon/scene/problems.h"

#include <algorithm>
#include <limits>

namespace shabon::scene {

namespace {

// Lines longer than this are written by machines and shown by nobody; copying them for every problem would be costly.
constexpr std::size_t longest_excerpt = 2000;

// The source of what the parser of stack expressions says about its text.
constexpr std::string_view optics_expression_source = "<stack>";

Diagnostics by_place(Diagnostics diagnostics) {
  const auto line = [](const Diagnostic& d) {
    const bool in_file = d.line > 0 && d.source != override_source;
    return in_file ? d.line : std::numeric_limits<int>::max();
  };
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return line(a) != line(b) ? line(a) < line(b) : a.column < b.column;
  });
  return diagnostics;
}

}  // namespace

Diagnostic Problems::diagnostic(const io::YamlNode* node, const Path& path, std::string message) const {
  Diagnostic result;
  result.key = path.text();
  result.message = std::move(message);
  if (node == nullptr || document_ == nullptr) return result;
  result.source = node->line > 0 ? document_->source : std::string(override_source);
  result.line = node->line;
  result.column = node->column;
  const auto index = static_cast<std::size_t>(node->line - 1);
  if (node->line > 0 && index < document_->lines.size() && document_->lines[index].size() <= longest_excerpt)
    result.excerpt = document_->lines[index];
  return result;
}

void Problems::keep(Diagnostic diagnostic) {
  const auto tells_it = [&](const Diagnostic& flaw) {
    if (flaw.source != diagnostic.source) return false;
    return flaw.line > 0 ? flaw.line == diagnostic.line && flaw.column == diagnostic.column
                         : flaw.key == diagnostic.key && flaw.message == diagnostic.message;
  };
  const auto flaws_end = errors_.begin() + static_cast<std::ptrdiff_t>(flaws_);
  if (!full() && std::none_of(errors_.begin(), flaws_end, tells_it)) errors_.push_back(std::move(diagnostic));
}

void Problems::adopt(const Diagnostics& flaws) {
  for (const Diagnostic& flaw : flaws) {
    keep(flaw);
    flaws_ = errors_.size();
  }
}

void Problems::add(const Path& path, std::string message, Failure failure) {
  const io::YamlNode* node = document_ != nullptr ? &nearest_node(document_->root, path) : nullptr;
  Diagnostic found = diagnostic(node, path, std::move(message));
  found.failure = failure;
  keep(std::move(found));
}

void Problems::add(const io::YamlNode& node, const Path& path, std::string message) {
  keep(diagnostic(&node, path, std::move(message)));
}

void Problems::add_warning(const Path& path, std::string message) {
  const io::YamlNode* node = document_ != nullptr ? &nearest_node(document_->root, path) : nullptr;
  Diagnostic found = diagnostic(node, path, std::move(message));
  found.severity = Severity::warning;
  if (warnings_.size() < most_shown) warnings_.push_back(std::move(found));
}

void Problems::add_from_text(const Path& path, const Diagnostic& inner) {
  if (!inner.source.empty() && inner.source != optics_expression_source) return add_from_file(path, inner);
  const io::YamlNode* node = document_ != nullptr ? &nearest_node(document_->root, path) : nullptr;
  Diagnostic found = diagnostic(node, path, inner.message);
  found.failure = inner.failure;
  if (node != nullptr && inner.line == 1 && inner.column > 0 && !found.excerpt.empty()) {
    const std::size_t text = found.excerpt.find(node->text, 0);
    const bool as_written = text != std::string::npos;
    if (as_written) found.column += inner.column - 1 + (node->quoted ? 1 : 0);
  }
  if (found.excerpt.empty() && inner.column > 0) found.message += " (column " + std::to_string(inner.column) + ")";
  keep(std::move(found));
}

void Problems::add_from_file(const Path& path, const Diagnostic& inner) {
  Diagnostic plain = inner;
  plain.excerpt.clear();
  plain.key.clear();
  std::string message = to_text(plain);
  const std::string_view label = "error: ";
  if (const std::size_t at = message.find(label); at != std::string::npos) message.erase(at, label.size());
  add(path, std::move(message), inner.failure);
}

bool Problems::has(const Path& path) const {
  if (errors_.empty()) return false;
  const std::string key = path.text();
  return std::any_of(errors_.begin(), errors_.end(), [&](const Diagnostic& error) {
    if (error.key.compare(0, key.size(), key) != 0) return false;
    return key.empty() || error.key.size() == key.size() || error.key[key.size()] == '.' ||
           error.key[key.size()] == '[';
  });
}

Diagnostics Problems::errors() const {
  Diagnostics result = by_place(errors_);
  if (full()) {
    Diagnostic rest;
    rest.source = document_ != nullptr ? document_->source : std::string();
    rest.message = "too many problems: only " + std::to_string(most_shown) + " are shown";
    result.push_back(std::move(rest));
  }
  return result;
}

Diagnostics Problems::warnings() const { return by_place(warnings_); }

}  // namespace shabon::scene
