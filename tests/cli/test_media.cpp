// media NAME...: n and k as text, CSV, JSON and drawings. The list itself is tested with the other listings.
#include <gtest/gtest.h>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"
#include "shabon/optics/media.h"

namespace shabon::test {
namespace {

const std::vector<double> wavelengths_nm = {400, 500, 600, 700};

TEST(MediaTables, CsvOfOneMediumIsAnNkFile) {
  const TemporaryFolder folder;
  const std::vector<std::string> ask = {"media", "Ag", "--wavelengths", "400:700:100", "--format", "csv"};
  const io::CsvTable table = table_of(ask);
  EXPECT_EQ(column(table, "wavelength_nm"), wavelengths_nm);
  const optics::Medium silver = optics::find_medium("ag").value();
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    EXPECT_EQ(column(table, "n")[i], silver.index(wavelengths_nm[i]).real());
    EXPECT_EQ(column(table, "k")[i], silver.index(wavelengths_nm[i]).imag());
  }
  folder.write("silver.csv", result_of(ask));
  Setting setting;
  setting.folder = folder.path();
  const Outcome again = run({"media", "file:silver.csv", "--wavelengths", "400:700:100", "--format", "csv"}, setting);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(result_of(ask).find(again.out.substr(again.out.find('\n'))), std::string::npos) << again.out;
}

TEST(MediaTables, SeveralMedia) {
  const std::vector<std::string> ask = {"media",    "water",         "mix(water 50%, 1.5)",
                                        "1.5+0.1i", "--wavelengths", "400,700"};
  auto with = [&](const char* format) {
    std::vector<std::string> arguments = ask;
    arguments.insert(arguments.end(), {"--format", format});
    return arguments;
  };
  const io::CsvTable table = table_of(with("csv"));
  const double water = optics::find_medium("water")->index(400).real();
  EXPECT_EQ(column(table, "n water").at(0), water);
  EXPECT_GT(column(table, "n mix(water 50%, 1.5 50%)").at(0), water);
  EXPECT_EQ(column(table, "k 1.5+0.1i").at(1), 0.1);
  const io::YamlDocument json = json_of(with("json"));
  EXPECT_EQ(numbers(json.root, "wavelength_nm"), (std::vector<double>{400, 700}));
  const io::YamlNode& media = *io::find(json.root, "media");
  ASSERT_EQ(media.items.size(), 3u);
  EXPECT_EQ(keys(media.items[0]),
            (std::vector<std::string>{"name", "description", "source", "form", "range_nm", "n", "k"}));
  EXPECT_EQ(numbers(media.items[0], "n").at(0), water);
  const std::string text = result_of(with("text"));
  for (const char* part : {"Daimon", "wavelength_nm", "182..1129 nm", "formula", "mixture", "1.500000", "0.1"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

// One warning a medium, of what was done at the wavelengths asked.
TEST(MediaTables, WarnOfWavelengthsOutsideTheRange) {
  const Outcome outcome = run({"media", "water", "Water", "SiO2", "--wavelengths", "100,1200"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            "warning: water: its source covers 182..1129 nm; below, the value at 182 nm is held; above, the value at "
            "1129 nm is held\n"
            "warning: SiO2: its source covers 210..6700 nm; below, the value at 210 nm is held\n");
  EXPECT_EQ(run({"media", "TiO2-rutile", "--wavelengths", "400"}).err,
            "warning: TiO2-rutile: its source covers 430..1530 nm; below, the formula is continued\n");
}

// What the help lists is what is read.
TEST(MediaTables, HelpNamesTheColumns) {
  const std::string help = run({"media", "--help"}).out;
  const TemporaryFolder folder;
  int names = 0;
  for (const char* kind : {"wavelength in nm  ", "wavelength in um  ", "n                 ", "k, if it absorbs  "}) {
    const std::size_t begin = help.find(kind);
    ASSERT_NE(begin, std::string::npos) << help;
    const std::string list = help.substr(begin + 18, help.find('\n', begin) - begin - 18);
    for (const std::string_view part : split(list, ',')) {
      const std::string name(trim(part)), first = kind[0] == 'w' ? name : "nm", n = kind[0] == 'n' ? name : "n",
                                          k = kind[0] == 'k' ? name : "k";
      const bool um = std::string_view(kind).find(" um") != std::string_view::npos;
      const auto file = folder.write("a.csv", first + "," + n + "," + k + (um ? "\n0.5,1.5,0.1\n" : "\n500,1.5,0.1\n"));
      EXPECT_EQ(column(table_of({"media", "file:" + file.string(), "--wavelengths", "500", "--format", "csv"}), "k"),
                std::vector<double>{0.1})
          << name;
      ++names;
    }
  }
  EXPECT_GT(names, 15);
}

TEST(MediaTables, AFileWithoutASourceLeavesNoEmptyLine) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "nm,n\n500,1.5\n");
  const std::string text = result_of({"media", "file:" + file.string(), "--wavelengths", "500"});
  EXPECT_NE(text.find("500..500 nm\n\n "), std::string::npos) << text;
}

TEST(MediaTables, Drawings) {
  const TemporaryFolder folder;
  Setting setting;
  setting.folder = folder.path();
  const Outcome outcome = run({"media", "Ag", "TiO2-rutile", "-o", "a.svg", "-o", "b.csv", "-o", "c.png"}, setting);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"a.svg", "b.csv", "c.png"}));
  const std::string svg = read_all(folder.path() / "a.svg");
  for (const char* part : {"<svg", "refractive index n", "extinction k", "vacuum wavelength (nm)", ">Ag<",
                           ">TiO2-rutile<", "dashed: beyond what the source covers", "stroke-dasharray"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_EQ(read_all(folder.path() / "c.png").substr(1, 3), "PNG");
  run({"media", "SiO2", "-o", "d.svg"}, setting);
  const std::string clear = read_all(folder.path() / "d.svg");
  EXPECT_EQ(clear.find("extinction"), std::string::npos);  // nothing to draw
  EXPECT_EQ(clear.find("dashed"), std::string::npos);
}

TEST(MediaTables, Complaints) {
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* message;
  };
  const Case cases[] = {
      {{"media", "watr"}, 3, "<medium>:1:1: error: unknown medium 'watr'; did you mean 'water'?\n    watr\n    ^\n"},
      {{"media", "Q"}, 3, "unknown medium 'Q'; known: vacuum, air, "},
      {{"media", "water", "mix(water 70%, glycrol 30%)"}, 3, "<medium>:1:16: error: unknown medium 'glycrol'"},
      {{"media", "water 300nm"}, 3, "expected one medium and nothing after it, got '300nm'"},
      {{"media", "file:gone.csv"}, 4, "gone.csv"},
      {{"media", "-o", "a.svg"}, 2, "--output: expected the names of media to draw"},
      {{"media", "--wavelengths", "400"}, 2, "--wavelengths: expected the names of media to print"},
      {{"media", "water", "-o", "a.svg", "--format", "csv"}, 2, "--format: expected without --output"},
      {{"media", "water", "-o", "a.gif"}, 2, "expected a file ending in"},
      {{"media", "water", "--wavelengths", "0"}, 2, "--wavelengths"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << one.arguments.back();
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(one.message), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace shabon::test
