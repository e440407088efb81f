// What the program prints, read back.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shabon/io/csv.h"
#include "shabon/io/yaml.h"

namespace shabon::test {

// Standard output of a command that must succeed without a word.
std::string result_of(const std::vector<std::string>& arguments);

// The same as a table, and one of its columns.
io::CsvTable table_of(const std::vector<std::string>& arguments);
std::vector<double> column(const io::CsvTable& table, std::string_view name);

// The same as JSON; every JSON text is a YAML text.
io::YamlDocument json_of(const std::vector<std::string>& arguments);
std::vector<std::string> keys(const io::YamlNode& node);
std::vector<double> numbers(const io::YamlNode& node, std::string_view key);

}  // namespace shabon::test
