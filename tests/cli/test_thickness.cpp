// shabon thickness: what it finds, prints and refuses, and that its page shows what it prints.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"

namespace shabon::test {
namespace {

const std::string oxide = "air | SiO2 ? | Si";
const std::string soap = "air | water ? | air";

std::string hex_of(const std::string& stack, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {"color", stack, "--format", "json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return io::find(json_of(arguments).root, "hex")->text;
}

Setting in_folder(const TemporaryFolder& folder) {
  Setting setting;
  setting.folder = folder.path();
  setting.environment = {{"NO_COLOR", "1"}};
  return setting;
}

// The JSON of a question that must be answered, whatever is said beside it.
io::YamlDocument answer(std::vector<std::string> arguments, const std::filesystem::path& folder = {}) {
  arguments.insert(arguments.begin(), "thickness");
  arguments.insert(arguments.end(), {"--format", "json"});
  Setting setting;
  setting.folder = folder;
  const Outcome outcome = run(arguments, setting);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  auto json = io::parse_yaml(outcome.out, "answer");
  EXPECT_TRUE(json.ok()) << outcome.out;
  return json ? std::move(*json) : io::YamlDocument{};
}

const io::YamlNode& candidate(const io::YamlDocument& json, std::size_t index) {
  return io::find(json.root, "candidates")->items.at(index);
}

double number(const io::YamlNode& node, std::string_view key) { return *parse_number(io::find(node, key)->text); }

TEST(Thickness, FindsTheFilmOfAColour) {
  const std::vector<std::string> lamp = {"--illuminant", "A", "--angle", "30"};
  std::vector<std::string> arguments = {oxide, "--color", hex_of("air | SiO2 285nm | Si", lamp)};
  arguments.insert(arguments.end(), lamp.begin(), lamp.end());
  const io::YamlDocument json = answer(arguments);
  EXPECT_EQ(io::find(json.root, "verdict")->text, "one");
  EXPECT_NEAR(number(candidate(json, 0), "thickness_nm"), 285, 1);
  EXPECT_LT(number(candidate(json, 0), "dE2000"), 0.5);
  EXPECT_EQ(number(candidate(json, 0), "order"), 2);
}

TEST(Thickness, ReadsColoursInEverySpace) {
  // Display P3 and the like by what `color` prints of the same film.
  const io::YamlDocument film = json_of({"color", "air | SiO2 285nm | Si", "--format", "json", "--space",
                                         "XYZ,xyY,Lab,LCh,Oklab,sRGB,Display P3,Rec.2020,ACEScg"});
  const io::YamlNode* spaces = io::find(film.root, "spaces");
  ASSERT_NE(spaces, nullptr);
  int count = 0;
  for (const io::YamlEntry& entry : spaces->entries) {
    const std::vector<double> v = numbers(entry.second, "values");
    const std::string color =
        entry.first.text + ":" + format_exact(v[0]) + "," + format_exact(v[1]) + "," + format_exact(v[2]);
    EXPECT_NEAR(number(candidate(answer({oxide, "--color", color}), 0), "thickness_nm"), 285, 1e-3) << color;
    ++count;
  }
  EXPECT_EQ(count, 9);
}

TEST(Thickness, SaysWhatIsAmbiguousAndWhatIsNothing) {
  EXPECT_EQ(io::find(answer({soap, "--color", "Lab:22.3,-10.8,2.1", "--uncertainty", "3"}).root, "verdict")->text,
            "several");
  const Outcome none = run({"thickness", soap, "--color", "#c896bb"});
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_NE(none.out.find("No thickness in the range gives this colour"), std::string::npos);
  EXPECT_NE(none.err.find("--ignore-lightness"), std::string::npos);
  EXPECT_EQ(io::find(answer({soap, "--color", "#c896bb"}).root, "verdict")->text, "none");
  const Outcome clipped = run({"thickness", soap, "--color", hex_of("air | water 200nm | air")});
  EXPECT_NE(clipped.err.find("0 or 255 may stand for anything beyond"), std::string::npos) << clipped.err;
  const Outcome dark = run({"thickness", soap, "--color", "#333333", "--uncertainty", "0.1"});
  EXPECT_NE(dark.err.find("rounding to bytes alone"), std::string::npos) << dark.err;
}

TEST(Thickness, FindsTheFilmsOfASpectrum) {
  const TemporaryFolder folder;
  folder.write("a.csv", result_of({"spectrum", "air | Si3N4 112nm | SiO2 300nm | Si", "--angle", "0,60"}));
  const io::YamlDocument json = answer(
      {"air | Si3N4 0..300nm | SiO2 0..600nm | Si", "--spectrum", "a.csv", "--columns", "R_s,R_p"}, folder.path());
  const std::vector<double> thickness_nm = numbers(candidate(json, 0), "thickness_nm");
  ASSERT_EQ(thickness_nm.size(), 2u);
  EXPECT_NEAR(thickness_nm[0], 112, 1e-3);
  EXPECT_NEAR(thickness_nm[1], 300, 1e-3);
  EXPECT_EQ(io::find(json.root, "verdict")->text, "one");

  // In percent, with a wrong calibration.
  std::string scaled = "wavelength_nm,R (%)\n";
  const io::CsvTable table = table_of({"spectrum", "air | SiO2 500nm | Si", "--wavelengths", "400:800:5"});
  const std::vector<double> wavelengths_nm = column(table, "wavelength_nm"), R = column(table, "R_s");
  for (std::size_t i = 0; i < R.size(); ++i)
    scaled += format_exact(wavelengths_nm[i]) + "," + format_exact(R[i] * 80) + "\n";
  folder.write("b.csv", scaled);
  const io::YamlDocument free = answer({oxide, "--spectrum", "b.csv", "--ignore-scale"}, folder.path());
  EXPECT_NEAR(numbers(candidate(free, 0), "thickness_nm").at(0), 500, 1e-4);
  EXPECT_NEAR(number(candidate(free, 0), "scale"), 0.8, 1e-6);
  const Outcome fixed = run({"thickness", oxide, "--spectrum", "b.csv", "--noise", "0.001"}, in_folder(folder));
  EXPECT_NE(fixed.err.find("times the stated noise"), std::string::npos) << fixed.err;
}

// A thick metal: one line for all of it, whatever the number of lines, and no certainty.
TEST(Thickness, SaysThatALayerIsOpaque) {
  for (const char* metal : {"Ag", "Al"}) {
    const std::string film = std::string("air | ") + metal + " ? | glass";
    const std::vector<std::string> asked = {film,
                                            "--color",
                                            hex_of(std::string("air | ") + metal + " 300nm | glass"),
                                            "--uncertainty",
                                            "5",
                                            "--range",
                                            "0:500nm",
                                            "--most",
                                            "1"};
    const io::YamlDocument json = answer(asked);
    EXPECT_EQ(io::find(json.root, "verdict")->text, "undetermined");
    EXPECT_EQ(io::find(candidate(json, 0), "opaque")->text, "true");
    const std::vector<double> level = numbers(candidate(json, 0), "level_nm"),
                              interval = numbers(candidate(json, 0), "interval_nm");
    EXPECT_LT(level[0], 100);
    EXPECT_EQ(level[1], 500);
    const double at = number(candidate(json, 0), "thickness_nm"), weight = number(candidate(json, 0), "weight");
    EXPECT_GT(at, interval[0]);
    EXPECT_LT(at, interval[1]);
    EXPECT_GT(weight, 0.9);
    EXPECT_NEAR(number(json.root, "unlisted_weight"), 1 - weight, 1e-12);
    std::vector<std::string> text = asked;
    text.insert(text.begin(), "thickness");
    const Outcome outcome = run(text);
    EXPECT_NE(outcome.out.find("most of them opaque"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Undetermined"), std::string::npos) << outcome.out;
  }
}

// However few lines are wanted, they are the heaviest, and what the others weigh is said.
TEST(Thickness, HidesNoWeight) {
  const std::vector<std::string> asked = {soap, "--color", "Lab:22.3,-10.8,2.1", "--uncertainty", "3", "--most", "2"};
  const io::YamlDocument json = answer(asked);
  const double first = number(candidate(json, 0), "weight"), second = number(candidate(json, 1), "weight");
  EXPECT_GT(first, second);
  EXPECT_GT(first, 0.35);
  EXPECT_NEAR(number(json.root, "unlisted_weight"), 1 - first - second, 1e-12);
  std::vector<std::string> text = asked;
  text.insert(text.begin(), "thickness");
  EXPECT_NE(run(text).out.find("not listed (3"), std::string::npos) << run(text).out;
}

TEST(Thickness, TellsWhichAngleItAssumes) {
  const TemporaryFolder folder;
  folder.write("one.csv", result_of({"spectrum", "air | SiO2 300nm | Si", "--angle", "40"}));
  folder.write("two.csv", result_of({"spectrum", "air | SiO2 300nm | Si", "--angle", "0,40"}));
  struct Case {
    std::vector<std::string> arguments;
    std::string said, angles, from;
  };
  const Case cases[] = {{{"one.csv"}, "one.csv has no column angle_deg; 0 degrees is assumed", "0", "assumption"},
                        {{"one.csv", "--angle", "40"}, "", "40", "statement"},
                        {{"two.csv"}, "", "0 40", "file"},
                        {{"two.csv", "--angle", "40"}, "--angle is passed over", "0 40", "file"}};
  for (const Case& c : cases) {
    std::vector<std::string> arguments = {"thickness", oxide, "--columns", "R_s,R_p", "--format", "json", "--spectrum"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    const Outcome outcome = run(arguments, in_folder(folder));
    if (c.said.empty())
      EXPECT_EQ(outcome.err.find("angle"), std::string::npos) << outcome.err;
    else
      EXPECT_NE(outcome.err.find(c.said), std::string::npos) << outcome.err;
    const auto json = io::parse_yaml(outcome.out, "answer");
    ASSERT_TRUE(json.ok());
    std::string angles;
    for (const double deg : numbers(json->root, "angles_deg"))
      angles += (angles.empty() ? "" : " ") + format_number(deg);
    EXPECT_EQ(angles, c.angles);
    EXPECT_EQ(io::find(json->root, "angles_from")->text, c.from);
  }
}

TEST(Thickness, FewValuesAreNotSure) {
  const TemporaryFolder folder;
  folder.write("two.csv", "wavelength_nm,R\n400,0.27514\n700,0.33538\n");
  const io::YamlDocument json = answer({oxide, "--spectrum", "two.csv"}, folder.path());
  EXPECT_EQ(io::find(json.root, "verdict")->text, "several");
  EXPECT_LT(number(candidate(json, 0), "weight"), 0.6);
  const Outcome outcome = run({"thickness", oxide, "--spectrum", "two.csv"}, in_folder(folder));
  EXPECT_NE(outcome.err.find("2 values for 1 unknown hardly tell how large their noise is"), std::string::npos);
}

TEST(Thickness, FormsHoldTheSameNumbers) {
  const std::vector<std::string> arguments = {oxide, "--color", "Lab:43.8,25.8,-38.8", "--uncertainty", "5"};
  std::vector<std::string> csv = arguments;
  csv.insert(csv.begin(), "thickness"), csv.insert(csv.end(), {"--format", "csv"});
  const io::CsvTable table = table_of(csv);
  const io::YamlDocument json = answer(arguments);
  const std::vector<double> thickness_nm = column(table, "thickness_nm"), weight = column(table, "weight");
  ASSERT_EQ(thickness_nm.size(), io::find(json.root, "candidates")->items.size());
  double sum = 0;
  for (std::size_t i = 0; i < thickness_nm.size(); ++i) {
    EXPECT_EQ(number(candidate(json, i), "thickness_nm"), thickness_nm[i]);
    EXPECT_EQ(number(candidate(json, i), "weight"), weight[i]);
    sum += weight[i];
  }
  EXPECT_NEAR(sum, 1, 0.02);
  csv.insert(csv.end(), {"--most", "2"});
  EXPECT_EQ(table_of(csv).rows.size(), 2u);
}

struct Refused {
  std::vector<std::string> arguments;
  int exit_code;
  const char* said;
};

TEST(Thickness, RefusesWhatItCannotAnswer) {
  const TemporaryFolder folder;
  folder.write("r.csv", "wavelength_nm,R\n400,0.3\n500,0.4\n600,0.2\n");
  folder.write("percent.csv", "wavelength_nm,R\n400,30\n500,40\n");
  folder.write("one.csv", "wavelength_nm,R\n400,0.3\n");
  const Refused refused[] = {
      {{}, 2, "expected STACK"},
      {{soap}, 2, "--color: expected this or --spectrum, got neither"},
      {{"air | water 3nm | air", "--color", "#123456"}, 3, "<stack>:1:13: error: expected ? or a range such as"},
      {{"air | (ZnS 58nm | MgF2 99nm)^2 | glass", "--spectrum", "r.csv"}, 3, "<stack>:1:12: error: expected ?"},
      {{"air | water", "--color", "#123456"}, 3, "<stack>:1:5: error: expected ?"},
      {{soap, "--color", "#123456", "--spectrum", "r.csv"}, 2, "expected without --spectrum, got both"},
      {{soap, "--color", "#12345"}, 2, "expected #rrggbb or SPACE:A,B,C"},
      {{soap, "--color", "#12345g"}, 2, "expected #rrggbb or SPACE:A,B,C"},
      {{soap, "--color", "purple"}, 2, "expected #rrggbb or SPACE:A,B,C"},
      {{soap, "--color", "Lob:1,2,3"}, 2, "did you mean 'Lab'?"},
      {{soap, "--color", "Lab:1,2"}, 2, "expected three numbers"},
      {{soap, "--color", "Lab:1,2,nan"}, 2, "expected numbers"},
      {{soap, "--color", "#123456", "--noise", "0.1"}, 2, "--noise: expected with --spectrum only"},
      {{soap, "--color", "#123456", "--percent"}, 2, "--percent: expected with --spectrum only"},
      {{soap, "--spectrum", "r.csv", "--illuminant", "A"}, 2, "--illuminant: expected with --color only"},
      {{soap, "--spectrum", "r.csv", "--ignore-lightness"}, 2, "--ignore-lightness: expected with --color only"},
      {{soap, "--color", "#123456", "--color", "#123456", "--angle", "1,2,3"}, 2, "one for each colour (2); got 3"},
      {{soap, "--spectrum", "r.csv", "--angle", "1,2"}, 2, "expected one angle for a spectrum"},
      {{soap, "--color", "#123456", "--range", "5"}, 2, "expected A:B such as 100:900nm"},
      {{soap, "--color", "#123456", "--range", "9:5nm"}, 2, "A < B"},
      {{soap, "--color", "#123456", "--uncertainty", "0"}, 2, "--uncertainty"},
      {{soap, "--color", "#123456", "--most", "0"}, 2, "--most"},
      {{soap, "--color", "#000000", "--ignore-lightness"}, 2, "expected a colour with a luminance above 0"},
      {{soap, "--color", "Lab:50,0,0", "--adapt", "bradford"}, 2, "a white of its own, got Lab"},
      {{"air | water ? | 1.5 ? | air", "--color", "#123456"}, 2, "several need --spectrum"},
      {{"air | 1.3 ? | 1.4 ? | 1.5 ? | 1.6 ? | 1.7 ? | air", "--spectrum", "r.csv"}, 2, "at most 4 unknown"},
      {{soap, "--spectrum", "r.csv", "--columns", "R_x"}, 2, "did you mean 'R_s'?"},
      {{soap, "--color", "#123456", "--range", "0:9mm"}, 3, "expected a range of at most"},
      {{"air | watr ? | air", "--color", "#123456"}, 3, "did you mean 'water'?"},
      {{"air | water 9..3nm | air", "--color", "#123456"}, 3, "a range that rises"},
      {{soap, "--spectrum", "percent.csv"}, 3, "percent.csv:2:5: error: expected a share"},
      {{soap, "--spectrum", "one.csv"}, 3, "expected more measured values than unknowns"},
      {{soap, "--spectrum", "gone.csv"}, 4, "gone.csv: error: cannot read"},
  };
  for (const Refused& c : refused) {
    std::vector<std::string> arguments = c.arguments;
    arguments.insert(arguments.begin(), "thickness");
    const Outcome outcome = run(arguments, in_folder(folder));
    EXPECT_EQ(outcome.exit_code, c.exit_code) << c.said << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(c.said), std::string::npos) << c.said << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << c.said;
  }
}

// Every `$ shabon ...` of the page with what stands below it, up to the next or the end of the block; `$ cat` shows
// files.
TEST(Thickness, ThePageShowsWhatIsPrinted) {
  const TemporaryFolder folder;
  std::istringstream page(read_all(std::filesystem::path(SHABON_SOURCE_DIR) / "docs/thickness.md"));
  std::vector<std::pair<std::string, std::string>> examples;
  bool is_output = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) is_output = false;
    if (is_output && !line.starts_with("$ ")) examples.back().second += line + "\n";
    if (!line.starts_with("$ ")) continue;
    examples.emplace_back(line.substr(2), "");
    is_output = true;
  }
  ASSERT_GT(examples.size(), 8u);
  for (const auto& [command, shown] : examples) {
    std::vector<std::string> arguments = words(command);
    if (arguments.front() == "cat") {
      folder.write(arguments.at(1), shown);
      continue;
    }
    ASSERT_EQ(arguments.front(), "shabon") << command;
    arguments.erase(arguments.begin());
    std::string file;
    if (arguments.size() > 2 && arguments[arguments.size() - 2] == ">") {
      file = arguments.back();
      arguments.resize(arguments.size() - 2);
    }
    const Outcome outcome = run(arguments, in_folder(folder));
    EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
    if (!file.empty()) folder.write(file, outcome.out);
    EXPECT_EQ(outcome.err + (file.empty() ? outcome.out : ""), shown) << command;
  }
}

// The examples of --help find something.
TEST(Thickness, HelpShowsExamplesThatWork) {
  std::istringstream help(run({"thickness", "--help"}).out);
  int count = 0;
  for (std::string line; std::getline(help, line);) {
    if (line.find("  shabon thickness ") != 0 || line.find("--color") == std::string::npos) continue;
    std::vector<std::string> arguments = words(line.substr(2));
    arguments.erase(arguments.begin(), arguments.begin() + 2);
    EXPECT_NE(io::find(answer(arguments).root, "verdict")->text, "none") << line;
    ++count;
  }
  EXPECT_EQ(count, 4);
}

// A layer without phase has no orders and no fringes that wavelengths could miss, however thick it is.
TEST(Thickness, FindsIncoherentLayers) {
  const std::string film = "air | 1.5+1e-5i ? incoherent | air";
  const std::vector<std::string> asked = {
      "thickness",     film,      "--color", hex_of("air | 1.5+1e-5i 2.5mm incoherent | air", {"--transmitted"}),
      "--transmitted", "--range", "0:5mm"};
  const Outcome text = run(asked);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.find("order"), std::string::npos) << text.out;
  const io::YamlDocument json = answer({asked.begin() + 1, asked.end()});
  EXPECT_NEAR(number(candidate(json, 0), "thickness_nm"), 2.5e6, 3e4);
  EXPECT_EQ(io::find(candidate(json, 0), "order")->kind, io::YamlNode::Kind::null);

  const TemporaryFolder folder;
  folder.write("a.csv", run({"spectrum", "air | 1.5+1e-5i 2.5mm incoherent | air", "--wavelengths", "400:800:20"}).out);
  const Outcome measured =
      run({"thickness", film, "--spectrum", "a.csv", "--range", "0:5mm", "--angle", "0"}, in_folder(folder));
  EXPECT_EQ(measured.exit_code, 0) << measured.err;
  EXPECT_EQ(measured.err, "");
  EXPECT_NE(measured.out.find("2500000"), std::string::npos) << measured.out;
}

TEST(Thickness, TellsOfSharesThatNoFilmHas) {
  const TemporaryFolder folder;
  folder.write("a.csv", "nm,R,angle_deg\n400,-0.3,0\n500,0.2,0\n600,1.3,0\n");
  const Outcome outcome = run({"thickness", oxide, "--spectrum", "a.csv"}, in_folder(folder));
  EXPECT_NE(outcome.err.find("a share of -0.3, below 0"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("a share of 1.3, above 1"), std::string::npos) << outcome.err;
}

TEST(Thickness, TellsWhatLightIntoAnAbsorbingMediumIs) {
  const Outcome outcome = run({"thickness", "air | TiO2 ? | Ti", "--color", "#808080", "--transmitted"});
  EXPECT_NE(outcome.err.find("Ti absorbs: transmitted is the light that enters it"), std::string::npos) << outcome.err;
  EXPECT_EQ(run({"thickness", "air | TiO2 ? | Ti", "--color", "#808080"}).err.find("absorbs"), std::string::npos);
}

}  // namespace
}  // namespace shabon::test
