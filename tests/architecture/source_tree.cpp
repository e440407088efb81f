#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace shabon::architecture {
namespace {

constexpr int most_lines = 300;

// Rooms that need nothing but the standard library, and the one file that brings in the threads.
const std::set<std::string, std::less<>> plain_rooms = {"base", "math", "color", "optics", "film", "desk"};
constexpr std::string_view thread_file = "base/parallel.cpp";

// Headers that come with the compiler: the machine's own instructions.
const std::set<std::string, std::less<>> compiler_headers = {"immintrin.h", "arm_neon.h", "wasm_simd128.h"};

// The layout of packets follows the compiler's options, so only rooms that are compiled once for each kind of machine
// may see them (docs/decisions/0001).
constexpr std::string_view packet_header = "math/packet";
constexpr std::string_view variants_call = "shabon_variants(";

struct Include {
  int line = 0;
  std::string name;
  bool quoted = false;
};

struct SourceFile {
  std::string path;  // relative to shabon/
  std::string room;
  int lines = 0;
  bool pragma_once = false;
  std::vector<Include> includes;
};

bool is_header(std::string_view path) { return path.ends_with(".h"); }

SourceFile read_source(const std::filesystem::path& folder, const std::filesystem::path& file) {
  static const std::regex include_line(R"re(^\s*#\s*include\s*(<([^>]+)>|"([^"]+)"))re");
  SourceFile source;
  const std::filesystem::path relative = file.lexically_relative(folder);
  source.path = relative.generic_string();
  source.room = relative.has_parent_path() ? relative.begin()->string() : "";
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    ++source.lines;
    if (line == "#pragma once") source.pragma_once = true;
    std::smatch match;
    if (std::regex_search(line, match, include_line)) {
      const bool quoted = match[3].matched;
      source.includes.push_back({source.lines, quoted ? match[3].str() : match[2].str(), quoted});
    }
  }
  return source;
}

class House {
 public:
  House(const std::filesystem::path& root, const Rooms& rooms) : folder_(root / "shabon"), rooms_(rooms) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp") {
        SourceFile source = read_source(folder_, entry.path());
        files_.emplace(source.path, std::move(source));
      } else if (entry.is_regular_file() && extension != ".in" && entry.path().filename() != "CMakeLists.txt") {
        report(entry.path().lexically_relative(folder_).generic_string(), 0, "is no source");
      }
    }
  }

  std::vector<std::string> inspect() {
    for (const auto& [path, file] : files_) {
      if (!rooms_.contains(file.room)) report(path, 0, "is in no room");
      if (is_header(path) && !file.pragma_once) report(path, 0, "lacks #pragma once");
      if (file.lines > most_lines) report(path, file.lines, "is longer than " + std::to_string(most_lines) + " lines");
      if (!is_header(path) && !is_built(file)) report(path, 0, "is not in its room's CMakeLists.txt");
      for (const Include& include : file.includes) inspect_include(file, include);
      if (!is_header(path) && !has_variants(file.room) && reaches_packets(file)) {
        report(path, 0, "sees packets, whose layout follows the compiler's options; its room has no variants");
      }
    }
    std::sort(broken_.begin(), broken_.end());
    return broken_;
  }

 private:
  void report(const std::string& path, int line, const std::string& what) {
    broken_.push_back(path + ":" + std::to_string(line) + ": " + what);
  }

  void inspect_include(const SourceFile& file, const Include& include) {
    if (!include.quoted) {
      const bool standard =
          include.name.find_first_of("./") == std::string::npos || compiler_headers.contains(include.name);
      if (!standard && plain_rooms.contains(file.room) && file.path != thread_file) {
        report(file.path, include.line, "<" + include.name + "> is not the standard library");
      }
      return;
    }
    if (!include.name.starts_with("shabon/")) {
      report(file.path, include.line, "\"" + include.name + "\" is not written from the root: \"shabon/...\"");
      return;
    }
    const std::string name = include.name.substr(7);
    const std::string room = name.substr(0, name.find('/'));
    if (!files_.contains(name)) report(file.path, include.line, "\"" + include.name + "\" does not exist");
    const auto from = rooms_.find(file.room);
    const auto to = rooms_.find(room);
    if (from == rooms_.end() || to == rooms_.end() || file.room == room) return;
    if (to->second >= from->second) {
      report(file.path, include.line,
             "room '" + file.room + "' (" + std::to_string(from->second) + ") includes room '" + room + "' (" +
                 std::to_string(to->second) + ")");
    }
  }

  // The sources of a room may be listed in the CMakeLists.txt of the room or of a folder inside it.
  bool is_built(const SourceFile& file) const {
    for (std::filesystem::path folder = std::filesystem::path(file.path).parent_path(); !folder.empty();
         folder = folder.parent_path()) {
      std::ifstream stream(folder_ / folder / "CMakeLists.txt");
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      std::istringstream words(std::regex_replace(text, std::regex("[()]"), " "));
      const std::string name = std::filesystem::path(file.path).lexically_relative(folder).generic_string();
      if (std::find(std::istream_iterator<std::string>(words), {}, name) != std::istream_iterator<std::string>())
        return true;
    }
    return false;
  }

  bool has_variants(const std::string& room) const {
    std::ifstream stream(folder_ / room / "CMakeLists.txt");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return text.find(variants_call) != std::string::npos;
  }

  bool reaches_packets(const SourceFile& file) {
    std::set<std::string> seen;
    std::vector<const SourceFile*> open = {&file};
    while (!open.empty()) {
      const SourceFile& next = *open.back();
      open.pop_back();
      if (next.path.starts_with(packet_header)) return true;
      for (const Include& include : next.includes) {
        if (!include.quoted || !include.name.starts_with("shabon/")) continue;
        const auto found = files_.find(include.name.substr(7));
        if (found != files_.end() && seen.insert(found->first).second) open.push_back(&found->second);
      }
    }
    return false;
  }

  std::filesystem::path folder_;
  const Rooms& rooms_;
  std::map<std::string, SourceFile> files_;
  std::vector<std::string> broken_;
};

}  // namespace

Rooms parse_rooms(std::string_view list) {
  Rooms rooms;
  std::istringstream stream{std::string(list)};
  for (std::string entry; std::getline(stream, entry, ',');) {
    const std::size_t equals = entry.find('=');
    rooms.emplace(entry.substr(0, equals), std::stoi(entry.substr(equals + 1)));
  }
  return rooms;
}

std::vector<std::string> broken_rules(const std::filesystem::path& root, const Rooms& rooms) {
  return House(root, rooms).inspect();
}

}  // namespace shabon::architecture
