#include "printed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "child.h"
#include "shabon/base/text.h"

namespace shabon::test {

std::string result_of(const std::vector<std::string>& arguments) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

io::CsvTable table_of(const std::vector<std::string>& arguments) {
  const Result<io::CsvTable> table = io::parse_csv(result_of(arguments), "output");
  EXPECT_TRUE(table.ok());
  return table ? *table : io::CsvTable{};
}

std::vector<double> column(const io::CsvTable& table, std::string_view name) {
  const Result<std::vector<double>> values = io::numbers(table, name);
  EXPECT_TRUE(values.ok()) << name;
  return values ? *values : std::vector<double>{};
}

io::YamlDocument json_of(const std::vector<std::string>& arguments) {
  const Result<io::YamlDocument> document = io::parse_yaml(result_of(arguments), "output");
  EXPECT_TRUE(document.ok());
  return document ? *document : io::YamlDocument{};
}

std::vector<std::string> keys(const io::YamlNode& node) {
  std::vector<std::string> names;
  for (const auto& [key, value] : node.entries) names.push_back(key.text);
  return names;
}

std::vector<double> numbers(const io::YamlNode& node, std::string_view key) {
  std::vector<double> values;
  const io::YamlNode* list = io::find(node, key);
  EXPECT_NE(list, nullptr) << key;
  if (list == nullptr) return values;
  for (const io::YamlNode& item : list->items) values.push_back(parse_number(item.text).value_or(NAN));
  return values;
}

}  // namespace shabon::test
