// Reads the CSV files of tests/data/optics: '#' lines are comments, the next line names the columns.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "shabon/base/text.h"

namespace shabon::optics {

class VectorRow {
 public:
  VectorRow(const std::map<std::string, std::size_t>& columns, std::vector<std::string> fields)
      : columns_(&columns), fields_(std::move(fields)) {}

  const std::string& text(const std::string& column) const { return fields_.at(columns_->at(column)); }
  double number(const std::string& column) const { return parse_number(text(column)).value(); }
  std::vector<double> list(const std::string& column) const {  // separated by ';', maybe empty
    std::vector<double> values;
    if (text(column).empty()) return values;
    for (std::string_view part : split(text(column), ';')) values.push_back(parse_number(part).value());
    return values;
  }

 private:
  const std::map<std::string, std::size_t>* columns_;
  std::vector<std::string> fields_;
};

struct VectorFile {
  std::map<std::string, std::size_t> columns;
  std::vector<VectorRow> rows;

  explicit VectorFile(const std::string& name) {
    std::ifstream file(std::string(SHABON_TEST_DATA) + "/optics/" + name);
    EXPECT_TRUE(file.good()) << name;
    for (std::string line; std::getline(file, line);) {
      if (line.empty() || line.front() == '#') continue;
      std::vector<std::string> fields;
      for (std::string_view field : split(line, ',')) fields.emplace_back(trim(field));
      if (columns.empty())
        for (std::size_t i = 0; i < fields.size(); ++i) columns[fields[i]] = i;
      else
        rows.emplace_back(columns, std::move(fields));
    }
  }
  VectorFile(const VectorFile&) = delete;
};

}  // namespace shabon::optics
