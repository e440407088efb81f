#include "shabon/io/csv.h"

#include <gtest/gtest.h>

#include <array>

#include "scratch.h"

namespace shabon::io {
namespace {

std::string complaint(std::string_view text) {
  const auto table = parse_csv(text, "t");
  if (table) return "none";
  const Diagnostic& error = table.errors().front();
  return std::to_string(error.line) + ":" + std::to_string(error.column) + " " + error.message;
}

TEST(Csv, ReadsCommentsNamesAndNumbers) {
  const auto table =
      parse_csv("# source: x\r\nlambda_nm, n ,label\r\n\r\n400,1.5,\"a, \"\"b\"\"\"\r\n#late\r\n500,-1e-3,c\r\n", "t");
  ASSERT_TRUE(table) << errors_of(table);
  EXPECT_EQ(table->comments, (std::vector<std::string>{" source: x", "late"}));
  EXPECT_EQ(table->columns, (std::vector<std::string>{"lambda_nm", "n", "label"}));
  EXPECT_EQ(*numbers(*table, "N"), (std::vector<double>{1.5, -1e-3}));
  EXPECT_EQ(table->rows[0].cells[2].text, "a, \"b\"");
  EXPECT_EQ(table->rows[1].line, 6);
  EXPECT_EQ(table->rows[1].cells[1].column, 5);
}

TEST(Csv, ReadsTablesWithoutNames) {
  const auto table = parse_csv(
      "\xEF\xBB\xBF"
      "1,2\n3,4",
      "t");
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->columns.empty());
  EXPECT_EQ(*numbers(*table, 1), (std::vector<double>{2, 4}));
  EXPECT_TRUE(fails(numbers(*table, "n"), Failure::content, "no column 'n'; found: columns without names"));
}

TEST(Csv, ReadsQuotedLineEnds) {
  const auto table = parse_csv("a,b\n\"x\ny\",1\nz,2\n", "t");
  ASSERT_TRUE(table) << errors_of(table);
  EXPECT_EQ(table->rows[0].cells[0].text, "x\ny");
  EXPECT_EQ(table->rows[0].cells[1].column, 4);
  EXPECT_EQ(table->rows[1].line, 4);
}

TEST(Csv, RefusesWithAPlace) {
  EXPECT_EQ(complaint(""), "1:1 a table without rows");
  EXPECT_EQ(complaint("# only\n"), "1:1 a table without rows");
  EXPECT_EQ(complaint("a,b\n"), "1:1 a table without rows");
  EXPECT_EQ(complaint("a,b\n1,2\n1,2,3\n"), "3:5 expected 2 cells, got 3");
  EXPECT_EQ(complaint("a,b\n1\n"), "2:1 expected 2 cells, got 1");
  EXPECT_EQ(complaint("a,b,A\n1,2,3\n"), "1:5 a second column named 'A'");
  EXPECT_EQ(complaint("a\n\xC3\xA9,\"x\n1,2\n"), "2:3 a quoted cell without its closing quote");
  EXPECT_EQ(complaint("a,b\n\"x\"y,2\n"), "2:4 expected ',' or the line's end after a quoted cell");
  EXPECT_EQ(complaint("a\n1\n\xB5"), "3:1 byte 0xB5 is not UTF-8 text");
  EXPECT_EQ(complaint(std::string_view("a\n1\0", 4)), "2:2 a NUL byte; this is not a text file");
}

TEST(Csv, PointsAtWhatIsNoNumber) {
  const auto table = parse_csv("a,b\n1,2\n3,x\n5,nan\n", "t.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(errors_of(numbers(*table, "b")),
            "t.csv:3:3: error: expected a number, got 'x'\n    3,x\n      ^\n"
            "t.csv:4:3: error: expected a number, got 'nan'\n    5,nan\n      ^\n");
  EXPECT_TRUE(fails(numbers(*table, "c"), Failure::content, "no column 'c'; found: a, b"));
}

TEST(Csv, SurvivesEveryPrefixAndManySlips) {
  const std::string text = "# c\na,\"b\"\"c\"\n1,\"2\n3\"\n4,5\n";
  for (std::size_t at = 0; at < text.size(); ++at) {
    (void)parse_csv(text.substr(0, at), "t");
    for (char slip : {'"', ',', '\n', '#', ' ', '\r'}) {
      std::string slipped = text;
      slipped[at] = slip;
      (void)parse_csv(slipped, "t");
    }
  }
}

TEST(Csv, WritesWhatItReads) {
  CsvWriter writer(std::array<std::string, 3>{"wavelength_nm", "a,\"b\"", " #c"});
  const std::array<double, 3> values{0.1, -1.0 / 3, 5e-324};
  writer.row(values);
  EXPECT_EQ(writer.text().substr(0, writer.text().find('\n')), "wavelength_nm,\"a,\"\"b\"\"\",\" #c\"");
  const auto table = parse_csv(writer.text(), "t");
  ASSERT_TRUE(table) << errors_of(table);
  EXPECT_EQ(table->columns[1], "a,\"b\"");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(numbers(*table, i)->front(), values[i]);
}

TEST(Csv, ReadsFiles) {
  const Scratch scratch;
  EXPECT_TRUE(read_csv(scratch.put("a.csv", "a\n1\n")));
  EXPECT_TRUE(fails(read_csv(scratch / "none.csv"), Failure::file, "No such file"));
}

}  // namespace
}  // namespace shabon::io
