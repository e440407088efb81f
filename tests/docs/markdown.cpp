#include "markdown.h"

#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace shabon::test {

namespace {

namespace fs = std::filesystem;

// The lines outside of ``` fences, those inside as empty ones; `inline code` is left out where `without_code`.
std::vector<std::string> prose_lines(const std::string& page, bool without_code) {
  static const std::regex code("`[^`]*`");
  std::vector<std::string> lines;
  std::istringstream stream(page);
  bool fenced = false;
  for (std::string line; std::getline(stream, line);) {
    const auto first = line.find_first_not_of(" >");
    const bool fence = first != std::string::npos && line.compare(first, 3, "```") == 0;
    if (fence) fenced = !fenced;
    if (fence || fenced) line.clear();
    lines.push_back(without_code ? std::regex_replace(line, code, "") : line);
  }
  return lines;
}

bool is_web_address(const std::string& target) {
  return target.find("://") != std::string::npos || target.starts_with("mailto:");
}

}  // namespace

std::vector<Link> links_in(const std::string& page) {
  // The text is not looked at: it may hold another link, such as a picture that is one.
  static const std::regex link(R"(\]\(<?([^()\s<>#]*)(?:#([^()\s<>]*))?>?(?:\s+"[^"]*")?\))");
  std::vector<Link> links;
  const std::vector<std::string> lines = prose_lines(page, true);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::sregex_iterator at(lines[i].begin(), lines[i].end(), link), end; at != end; ++at)
      links.push_back({(*at)[1], (*at)[2], static_cast<int>(i) + 1});
  return links;
}

std::set<std::string> anchors_in(const std::string& page) {
  std::set<std::string> anchors;
  for (const std::string& line : prose_lines(page, false)) {
    const auto level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
    std::string anchor;
    for (const char c : line.substr(level + 1)) {
      const auto letter = static_cast<unsigned char>(c);
      if (c == ' ') anchor += '-';
      if (c == '-' || c == '_' || letter >= 0x80 || std::isalnum(letter))
        anchor += static_cast<char>(std::tolower(letter));
    }
    std::string unique = anchor;
    for (int copy = 1; !anchors.insert(unique).second; ++copy) unique = anchor + "-" + std::to_string(copy);
  }
  return anchors;
}

std::vector<std::string> broken_links(const fs::path& path) {
  std::vector<std::string> broken;
  for (const Link& link : links_in(text_of(path))) {
    if (is_web_address(link.target)) continue;
    const fs::path target = link.target.empty() ? path : path.parent_path() / link.target;
    const std::string place = path.string() + ":" + std::to_string(link.line) + ": ";
    if (!fs::exists(target))
      broken.push_back(place + "there is no " + link.target);
    else if (!link.anchor.empty() && !anchors_in(text_of(target)).contains(link.anchor))
      broken.push_back(place + link.target + " has no heading #" + link.anchor);
  }
  return broken;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace shabon::test
