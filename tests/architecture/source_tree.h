// The rules of the house, read from the sources: which room may include what, and what every file must look like.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::architecture {

using Rooms = std::map<std::string, int, std::less<>>;  // name and number, from cmake/ShabonRoom.cmake

// "base=0,math=1,...".
Rooms parse_rooms(std::string_view list);

// Every broken rule below root/shabon, one line each: "optics/airy.h:7: ...". Empty when the house is in order.
std::vector<std::string> broken_rules(const std::filesystem::path& root, const Rooms& rooms);

}  // namespace shabon::architecture
