// The numbers of a CSV in tests/data: '#' lines are its source, the first other line names the columns.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "shabon/base/text.h"

using CsvRow = std::map<std::string, double>;

inline std::vector<CsvRow> read_csv(const std::string& name) {
  std::ifstream file(std::string(SHABON_TEST_DATA) + "/" + name);
  std::vector<std::string> columns;
  std::vector<CsvRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto fields = shabon::split(line, ',');
    if (columns.empty()) {
      columns.assign(fields.begin(), fields.end());
      continue;
    }
    CsvRow row;
    for (std::size_t i = 0; i < fields.size() && i < columns.size(); ++i) {
      const auto number = shabon::parse_number(fields[i]);
      EXPECT_TRUE(number) << name << ": " << line;
      row[columns[i]] = number.value_or(0);
    }
    EXPECT_EQ(fields.size(), columns.size()) << name << ": " << line;
    rows.push_back(row);
  }
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}
