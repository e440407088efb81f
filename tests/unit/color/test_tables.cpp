// What is built in is what data/ holds, and every file of data/ is built in and licensed.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/table_columns.h"

namespace {

using namespace shabon;
using namespace shabon::color;
namespace fs = std::filesystem;

const fs::path data_folder = fs::path(SHABON_SOURCE_DIR) / "data";

std::string read_all(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Csv {
  std::string file, name;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  // by column
};

Csv read(const fs::path& path) {
  Csv csv;
  csv.file = path.filename().string();
  std::istringstream text(read_all(path));
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("# name: ", 0) == 0) csv.name = line.substr(8);
    if (line.empty() || line[0] == '#') continue;
    const auto fields = split(line, ',');
    if (csv.columns.empty()) {
      csv.columns.assign(fields.begin(), fields.end());
      csv.values.resize(fields.size());
    } else {
      for (std::size_t i = 0; i < fields.size(); ++i) csv.values[i].push_back(parse_number(fields[i]).value());
    }
  }
  return csv;
}

std::vector<Csv> files_beginning_with(const std::string& prefix) {
  std::vector<Csv> files;
  for (const auto& entry : fs::directory_iterator(data_folder))
    if (entry.path().extension() == ".csv" && entry.path().filename().string().rfind(prefix, 0) == 0)
      files.push_back(read(entry.path()));
  EXPECT_FALSE(files.empty()) << prefix;
  return files;
}

void expect_built_in(const Csv& csv, std::span<const Table> tables) {
  SCOPED_TRACE(csv.file);
  const Table* found = nullptr;
  for (const Table& table : tables)
    if (table.name == csv.name) found = &table;
  ASSERT_TRUE(found) << "not in the list of shabon/color/CMakeLists.txt";
  ASSERT_EQ(found->columns.size(), csv.columns.size());
  for (std::size_t i = 0; i < csv.columns.size(); ++i) {
    EXPECT_EQ(found->column_names[i], csv.columns[i]);
    EXPECT_EQ(std::vector<double>(found->columns[i].begin(), found->columns[i].end()), csv.values[i]);
  }
}

TEST(Tables, EveryFileIsBuiltIn) {
  for (const Csv& csv : files_beginning_with("observer_")) expect_built_in(csv, tables::observers());
  for (const Csv& csv : files_beginning_with("illuminant_")) expect_built_in(csv, tables::illuminants());
  for (const Csv& csv : files_beginning_with("illuminants_")) expect_built_in(csv, tables::lamp_series());
  for (const Csv& csv : files_beginning_with("daylight_")) expect_built_in(csv, tables::daylight());
  for (const Csv& csv : files_beginning_with("rgb_basis")) expect_built_in(csv, tables::rgb_basis());
}

TEST(Tables, EveryFileIsNamedAmongTheLicences) {
  const std::string licences = read_all(data_folder / "LICENSES.md");
  for (const auto& entry : fs::directory_iterator(data_folder)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() != ".csv") continue;
    EXPECT_NE(licences.find("`" + file + "`"), std::string::npos) << file;
  }
}

TEST(Tables, CoverTheObserversRangeAtOneNanometre) {
  for (const auto list : {tables::observers(), tables::illuminants(), tables::lamp_series(), tables::rgb_basis()}) {
    for (const Table& table : list) {
      SCOPED_TRACE(table.name);
      for (const auto text : {table.description, table.unit, table.source, table.licence}) EXPECT_FALSE(text.empty());
      ASSERT_EQ(table.columns[0].size(), static_cast<std::size_t>(spectrum_size));
      for (std::size_t i = 0; i < table.columns[0].size(); ++i) EXPECT_EQ(table.columns[0][i], wavelength_nm(i));
      for (const auto column : table.columns)
        for (const double value : column) EXPECT_GE(value, 0);
    }
  }
}

TEST(Tables, DaylightCoversTheObserversRange) {
  const Table& table = tables::daylight().front();
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_LE(table.columns[0].front(), first_nm);
  EXPECT_GE(table.columns[0].back(), last_nm);
  for (std::size_t i = 1; i < table.columns[0].size(); ++i) EXPECT_EQ(table.columns[0][i] - table.columns[0][i - 1], 5);
}

TEST(Tables, AreFoundByNameInAnyCase) {
  for (const Observer& observer : observers()) EXPECT_EQ(find_observer(lower(observer.name)), &observer);
  for (const Illuminant& lamp : illuminants()) EXPECT_EQ(find_illuminant(lower(lamp.name)), &lamp);
  EXPECT_EQ(find_observer("1931"), &observer_1931());
  EXPECT_EQ(find_illuminant("d65"), &illuminants().front());
  for (const char* name : {"1931", "1964", "2015-2", "2015-10"}) EXPECT_TRUE(find_observer(name)) << name;
  for (const char* lamp : {"D65", "A", "E"}) EXPECT_TRUE(find_illuminant(lamp)) << lamp;
  EXPECT_EQ(find_illuminant("D66"), nullptr);
  EXPECT_EQ(find_observer(""), nullptr);
}

}  // namespace
