// shabon compare: what it prints, draws and refuses.
#include <gtest/gtest.h>

#include <sstream>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"
#include "shabon/desk/shortcuts.h"

namespace shabon::test {
namespace {

const std::string film = "air | water 0nm | air";
const std::string few = "0:400nm:50nm";

std::string error_of(const std::vector<std::string>& arguments, int exit_code) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

TEST(Compare, TextTellsEveryShortcut) {
  const std::string text = result_of({"compare", film, "--thickness", few});
  for (const desk::Shortcut& shortcut : desk::shortcuts())
    for (const std::string_view part : {shortcut.name, shortcut.description, shortcut.used_by})
      EXPECT_NE(text.find(part), std::string::npos) << part;
  for (const char* part : {"reflected at 0", "D65", "9 films", "mean", "median", "95 %", "max"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(Compare, FormsHoldTheSameNumbers) {
  const std::vector<std::string> arguments = {"compare", film, "--thickness", few, "--angle", "50", "--format"};
  const auto in = [&](const char* format) {
    std::vector<std::string> all = arguments;
    all.push_back(format);
    return all;
  };
  const io::CsvTable csv = table_of(in("csv"));
  const io::YamlDocument json = json_of(in("json"));
  EXPECT_EQ(numbers(json.root, "thickness_nm"), column(csv, "thickness_nm"));
  EXPECT_EQ(column(csv, "thickness_nm").size(), 9u);
  const io::YamlNode* list = io::find(json.root, "shortcuts");
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->items.size(), desk::shortcuts().size());
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    const std::string_view name = desk::shortcuts()[i].name;
    EXPECT_EQ(io::find(list->items[i], "name")->text, name);
    EXPECT_EQ(numbers(list->items[i], "dE2000"), column(csv, name)) << name;
  }
}

// Its table says that thick films are means, and so they are: along the normal Schlick's walls are exact.
TEST(Compare, ThickFilmsAreNotAliased) {
  const io::CsvTable table =
      table_of({"compare", film, "--thickness", "99um:101um:0.05um", "--exposure", "fit", "--format", "csv"});
  for (const char* name : {"schlick", "unpolarised-walls"})
    for (const double difference : column(table, name)) EXPECT_LT(difference, 0.001) << name;
  EXPECT_TRUE(std::any_of(table.comments.begin(), table.comments.end(), [](const std::string& comment) {
    return comment.find("means over each nanometre") != std::string::npos;
  }));
}

// The colours are those of `color`.
TEST(Compare, ExactColoursAreThoseOfColor) {
  const io::CsvTable csv = table_of({"compare", film, "--thickness", few, "--format", "csv", "--transmitted"});
  const io::YamlDocument json = json_of({"color", "air | water 150nm | air", "--format", "json", "--transmitted"});
  const std::vector<double> xyz = numbers(json.root, "XYZ");
  const char* names[] = {"X", "Y", "Z"};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(column(csv, names[i])[3], xyz[i], 1e-11);
}

TEST(Compare, SaysWhatAShortcutDoesNotKnow) {
  const std::vector<std::string> stack = {"compare", "air | MgF2 0nm | ZnS 60nm | glass", "--layer", "2", "--thickness",
                                          few};
  const Outcome text = run(stack);
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("knows a single layer"), std::string::npos);
  std::vector<std::string> csv = stack;
  csv.insert(csv.end(), {"--format", "csv"});
  const std::string table = run(csv).out;
  EXPECT_NE(table.find("# two-beam: left out"), std::string::npos);
  EXPECT_NE(table.find("thickness_nm,X,Y,Z,three-wavelengths,no-dispersion"), std::string::npos);
}

TEST(Compare, BrightnessCounts) {
  const auto mean = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"compare", film, "--thickness", few, "--format", "csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return column(table_of(arguments), "three-wavelengths");
  };
  EXPECT_NE(mean({"--exposure", "3"}), mean({}));
  EXPECT_NE(mean({"--exposure", "fit"}), mean({}));
  EXPECT_EQ(mean({"--exposure", "0"}), mean({}));
}

TEST(Compare, WritesCharts) {
  const TemporaryFolder folder;
  const std::string png = (folder.path() / "a.png").string(), svg = (folder.path() / "a.svg").string(),
                    csv = (folder.path() / "a.csv").string();
  const Outcome outcome = run({"compare", film, "--thickness", few, "-o", png, "-o", svg, "-o", csv});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(read_all(png).starts_with("\x89PNG"));
  const std::string drawing = read_all(svg);
  for (const desk::Shortcut& shortcut : desk::shortcuts())
    EXPECT_NE(drawing.find(shortcut.name), std::string::npos) << shortcut.name;
  EXPECT_EQ(read_all(svg), result_of({"compare", film, "--thickness", few, "--format", "svg"}));
  EXPECT_EQ(read_all(csv), result_of({"compare", film, "--thickness", few, "--format", "csv"}));
}

TEST(Compare, ExplainsWhatIsWrong) {
  EXPECT_NE(error_of({"compare"}, 2).find("STACK"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--thickness", "5"}, 2).find("A:B"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--thickness", "9:1nm"}, 2).find("A < B"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--angle", "91"}, 2).find("--angle"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--exposure", "bright"}, 2).find("--exposure"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--format", "csvv"}, 2).find("did you mean 'csv'"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--layer", "2"}, 2).find("--layer"), std::string::npos);
  EXPECT_NE(error_of({"compare", "air | MgF2 1nm | ZnS 1nm | air"}, 2).find("--layer"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--exposure", "fot"}, 2).find("did you mean 'fit'?"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--thickness", "0:10m"}, 2)
                .find("--thickness: expected a number in nm, um, mm or cm, got '10m'"),
            std::string::npos);
  EXPECT_NE(error_of({"compare", film, "-o", "a.pdf"}, 2).find(".png, .svg or .csv"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "-o", "a.svg", "--format", "csv"}, 2).find("--format"), std::string::npos);
  EXPECT_NE(error_of({"compare", "air | watr 0nm | air"}, 3).find("water"), std::string::npos);
  EXPECT_NE(error_of({"compare", "air | glass 1mm incoherent | air"}, 3).find("coherent"), std::string::npos);
  EXPECT_NE(error_of({"compare", film, "--illuminant", "file:/nowhere.csv"}, 4).find("/nowhere.csv"),
            std::string::npos);
  EXPECT_NE(error_of({"compare", film, "-o", "/nowhere/a.svg"}, 4).find("/nowhere"), std::string::npos);
}

// Every line that docs/shortcuts.md shows below a command is what the command prints.
TEST(Compare, DocumentationShowsWhatIsPrinted) {
  std::istringstream page(read_all(std::string(SHABON_SOURCE_DIR) + "/docs/shortcuts.md"));
  const std::string prompt = "$ shabon ";
  std::string printed_text;
  int commands = 0, lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(prompt)) {
      printed_text = run(words(line.substr(prompt.size()))).out;
      ++commands;
    } else if (line.starts_with("```")) {
      printed_text.clear();
    } else if (!printed_text.empty()) {
      EXPECT_NE(printed_text.find(line + "\n"), std::string::npos) << line;
      ++lines;
    }
  }
  EXPECT_GE(commands, 5);
  EXPECT_GE(lines, commands * static_cast<int>(desk::shortcuts().size()));
}

}  // namespace
}  // namespace shabon::test
