// Collects every problem of a scene and hands them out in the order of the file.
#pragma once

#include <cstddef>
#include <string>

#include "shabon/base/result.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/path.h"

namespace shabon::scene {

// What stands in place of a file name for values that came from the command line; their nodes have line 0.
inline constexpr std::string_view override_source = "--set";

class Problems {
 public:
  // More than this helps nobody, and a hostile file holds a million: the rest is left out.
  static constexpr std::size_t most_shown = 100;

  // `document` may be null: then problems have no place, only a path.
  explicit Problems(const io::YamlDocument* document) : document_(document) {}

  // At the value the path leads to, or where it belongs.
  void add(const Path& path, std::string message, Failure failure = Failure::content);
  void add(const io::YamlNode& node, const Path& path, std::string message);
  void add_warning(const Path& path, std::string message);

  // What was wrong with the text of the file itself, or with what was set from outside. Other problems at the same
  // places are only its echo.
  void adopt(const Diagnostics& flaws);

  // What another room said about the text of the value, e.g. a stack expression. Its columns count from the start of
  // the text; they become columns of the file where the text is written in it letter by letter.
  void add_from_text(const Path& path, const Diagnostic& inner);

  // What was wrong with a file that the value names: at the value, and at the place in that file if it has one.
  void add_from_file(const Path& path, const Diagnostic& inner);

  // Whether a problem of the value or of something in it is known already: then others may only be its echo.
  bool has(const Path& path) const;

  bool empty() const { return errors_.empty(); }
  bool full() const { return errors_.size() >= most_shown; }

  // Sorted by place; what came from the command line stands last.
  Diagnostics errors() const;
  Diagnostics warnings() const;

 private:
  Diagnostic diagnostic(const io::YamlNode* node, const Path& path, std::string message) const;
  void keep(Diagnostic diagnostic);

  const io::YamlDocument* document_;
  Diagnostics errors_, warnings_;
  std::size_t flaws_ = 0;  // how many of the errors were adopted; they stand first
};

}  // namespace shabon::scene
