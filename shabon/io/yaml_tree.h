// Turns yaml-cpp's events into a tree of nodes, and refuses what yaml-cpp lets pass. Inside the room only.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include "shabon/io/yaml.h"

namespace shabon::io {

// Thrown through yaml-cpp when a limit is reached; the diagnostic is recorded already.
struct YamlStop {};

// yaml-cpp counts columns in bytes; a place counts characters. Marks come almost in order, so the count goes on from
// the last one: a file that is one long line stays linear.
class YamlPlaces {
 public:
  explicit YamlPlaces(const std::vector<std::string>& lines) : lines_(lines) {}
  void locate(const YAML::Mark& mark, int& line, int& column);

 private:
  const std::vector<std::string>& lines_;
  std::size_t line_ = 0, byte_ = 0, character_ = 0;
};

class YamlTreeBuilder final : public YAML::EventHandler {
 public:
  YamlTreeBuilder(const std::string& source, const std::vector<std::string>& lines)
      : source_(source), lines_(lines), places_(lines) {}

  YamlNode& root() { return root_; }
  const Diagnostics& errors() const { return errors_; }
  // For what yaml-cpp itself refuses, with its words. Throws YamlStop when there are too many errors.
  void syntax_error(const YAML::Mark& mark, const std::string& problem);

  void OnDocumentStart(const YAML::Mark& mark) override;
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override;
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override;
  void OnMapEnd() override { close(); }

 private:
  // What a node costs when an alias repeats it.
  struct Size {
    std::size_t nodes = 1, text_bytes = 0, depth = 0;  // depth: containers within each other
    void contain(const Size& inner);
  };
  struct Frame {  // a sequence or mapping that is still open
    YamlNode node;
    YAML::anchor_t anchor = 0;
    Size size;
    std::optional<YamlNode> key;  // waits for its value
    bool key_usable = true;
    std::unordered_map<std::string, int> key_lines;
  };
  struct Anchored {
    YamlNode node;
    Size size;
  };

  YamlNode make(const YAML::Mark& mark, YamlNode::Kind kind);
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind);
  void close();
  void remember(YAML::anchor_t anchor, const YamlNode& node, const Size& size);
  void attach(YamlNode node, const Size& size);
  void take_key(Frame& frame, YamlNode node);
  void count(const Size& size, int line, int column);
  void error_at(int line, int column, std::string message);
  [[noreturn]] void stop_at(int line, int column, std::string message);

  const std::string& source_;
  const std::vector<std::string>& lines_;
  YamlPlaces places_;
  YamlNode root_;
  Diagnostics errors_;
  std::vector<Frame> frames_;
  std::map<YAML::anchor_t, Anchored> anchors_;  // complete nodes only
  Size total_{0, 0, 0};
  std::size_t anchored_nodes_ = 0;
  int documents_ = 0;
};

}  // namespace shabon::io
