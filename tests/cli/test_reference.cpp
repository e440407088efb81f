// shabon reference: the folder it fills, and what it leaves alone.
#include <gtest/gtest.h>

#include <filesystem>

#include "child.h"
#include "printed.h"
#include "shabon/api/version.h"
#include "shabon/desk/reference_tables.h"

namespace shabon::test {
namespace {

namespace fs = std::filesystem;

std::string error_of(const std::vector<std::string>& arguments, int exit_code) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

TEST(Reference, FillsAFolder) {
  const TemporaryFolder folder;
  const fs::path tables = folder.path() / "new" / "tables";
  const Outcome outcome = run({"reference", "--out", tables.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::size_t found = 0;
  for (const auto& entry : fs::directory_iterator(tables)) found += entry.is_regular_file() ? 1 : 0;
  const std::vector<desk::ReferenceFile> files = desk::reference_files(version());
  EXPECT_EQ(found, files.size());
  for (const desk::ReferenceFile& file : files) EXPECT_TRUE(read_all(tables / file.name) == file.text) << file.name;
}

TEST(Reference, ListsWithoutWriting) {
  const TemporaryFolder folder;
  Setting here;
  here.folder = folder.path();
  const Outcome outcome = run({"reference", "--list"}, here);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const desk::ReferenceFile& file : desk::reference_list())
    EXPECT_NE(outcome.out.find(file.name), std::string::npos) << file.name;
  for (const desk::ReferenceFilm& film : desk::reference_films())
    EXPECT_NE(outcome.out.find(film.expression), std::string::npos) << film.name;
  EXPECT_TRUE(folder.files().empty());
}

TEST(Reference, LeavesOtherFilesAndReplacesItsOwn) {
  const TemporaryFolder folder;
  folder.write("notes.txt", "mine");
  folder.write("index.csv", std::string(desk::reference_marker) + ", version 0: index\nold\n");
  const Outcome outcome = run({"reference", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_all(folder.path() / "notes.txt"), "mine");
  EXPECT_EQ(read_all(folder.path() / "index.csv").find("old"), std::string::npos);
}

TEST(Reference, OverwritesNothingThatIsNotItsOwn) {
  const TemporaryFolder folder;
  folder.write("README.md", "# My project\n");
  const std::string text = error_of({"reference", "--out", folder.path().string()}, 4);
  EXPECT_NE(text.find("README.md"), std::string::npos);
  EXPECT_NE(text.find("not overwritten"), std::string::npos);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"README.md"});
  EXPECT_EQ(read_all(folder.path() / "README.md"), "# My project\n");
}

TEST(Reference, ExplainsWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "x").string();
  EXPECT_NE(error_of({"reference"}, 2).find("--out"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out"}, 2).find("--out"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out", ""}, 2).find("--out"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out", "a", "--list"}, 2).find("--list"), std::string::npos);
  EXPECT_NE(error_of({"reference", "tables"}, 2).find("tables"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out", file}, 4).find("folder"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out", file + "/below"}, 4).find("below"), std::string::npos);
  EXPECT_NE(error_of({"reference", "--out", "/proc/nowhere"}, 4).find("/proc/nowhere"), std::string::npos);
  EXPECT_EQ(read_all(file), "x");
}

TEST(Reference, AFullDiskLeavesNoHalfTable) {
  const TemporaryFolder folder;
  Setting small;
  small.most_file_bytes = 100'000;
  const Outcome outcome = run({"reference", "--out", folder.path().string()}, small);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace shabon::test
