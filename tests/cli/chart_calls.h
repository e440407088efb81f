// How the tests call chart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "child.h"
#include "shabon/base/text.h"

namespace shabon::test {

using Arguments = std::vector<std::string>;

// As the help lists them.
inline std::vector<std::string> kinds() {
  const std::string help = run({"chart", "--help"}).out, head = "What to draw: ";
  const std::size_t begin = help.find(head) + head.size();
  std::vector<std::string> names;
  for (const std::string_view name : split(std::string_view(help).substr(begin, help.find('\n', begin) - begin), ','))
    names.emplace_back(trim(name));
  return names;
}

// Small enough to be quick.
inline Arguments quick(const std::string& kind) {
  if (kind == "newton") return {"chart", kind, "--thickness", "0:400nm:10nm", "--width", "600"};
  if (kind == "angle") return {"chart", kind, "--thickness", "0:400nm:40nm", "--angle", "0:80:20", "--width", "600"};
  if (kind == "profile") return {"chart", kind, "--model", "linear: {top_nm: 0, bottom_nm: 400}", "--width", "600"};
  return {"chart", kind, "--retardation", "0:1800nm:10nm", "--width", "600"};
}

inline Arguments operator+(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

inline Setting in(const TemporaryFolder& folder) {
  Setting setting;
  setting.folder = folder.path();
  return setting;
}

}  // namespace shabon::test
