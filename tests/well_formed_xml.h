// Whether a text is well-formed XML, as far as the project's own drawings go.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::test {

inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Every tag closed in order, every attribute in quotes, no bare '&' or '<', one element that holds all others.
inline bool is_well_formed(std::string_view xml) {
  std::vector<std::string> open;
  std::size_t roots = 0;
  for (std::size_t at = 0; (at = xml.find('<', at)) != std::string_view::npos;) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.empty() || tag.find('<') != std::string_view::npos || count(tag, "\"") % 2 != 0) return false;
    if (tag.front() == '?') continue;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
      continue;
    }
    if (open.empty()) ++roots;
    if (tag.back() != '/') open.emplace_back(tag.substr(0, tag.find(' ')));
  }
  for (std::size_t at = 0; (at = xml.find('&', at)) != std::string_view::npos; ++at)
    if (xml.substr(at, 5) != "&amp;" && xml.substr(at, 4) != "&lt;" && xml.substr(at, 4) != "&gt;" &&
        xml.substr(at, 6) != "&quot;")
      return false;
  return open.empty() && roots == 1;
}

}  // namespace shabon::test
