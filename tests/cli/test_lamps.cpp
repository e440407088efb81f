// lamps NAME...: spectra as text, CSV, JSON and drawings, and lamps of one's own. The list itself is tested with color.
#include <gtest/gtest.h>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/planck.h"
#include "shabon/color/xyz.h"

namespace shabon::test {
namespace {

Setting in(const TemporaryFolder& folder) {
  Setting setting;
  setting.folder = folder.path();
  return setting;
}

TEST(LampTables, CsvOfOneLampIsALampFile) {
  const TemporaryFolder folder;
  const std::vector<std::string> ask = {"lamps", "F11", "--format", "csv"};
  const io::CsvTable table = table_of(ask);
  const color::Illuminant& lamp = *color::find_illuminant("FL11");
  EXPECT_EQ(column(table, "power"), std::vector<double>(lamp.power.begin(), lamp.power.end()));
  folder.write("mine.csv", result_of(ask));
  const std::vector<std::string> film = {"color", "air | water 300nm | air", "--format", "json", "--illuminant"};
  auto from_file = film, from_library = film;
  from_file.emplace_back("file:mine.csv");
  from_library.emplace_back("F11");
  const Outcome outcome = run(from_file, in(folder));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const io::YamlDocument own = *io::parse_yaml(outcome.out, "json"), known = json_of(from_library);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(numbers(own.root, "XYZ")[i], numbers(known.root, "XYZ")[i], 1e-14);
}

TEST(LampTables, SeveralLamps) {
  const std::vector<std::string> ask = {"lamps", "D65", "blackbody:3000", "LED-B3", "--wavelengths", "450,560.5,700"};
  const auto as = [&](const char* format) {
    std::vector<std::string> arguments = ask;
    arguments.insert(arguments.end(), {"--format", format});
    return arguments;
  };
  const color::Spectrum planck = color::blackbody_power(3000);
  const io::CsvTable table = table_of(as("csv"));
  EXPECT_EQ(column(table, "blackbody:3000K")[0], planck[90]);
  EXPECT_NEAR(column(table, "blackbody:3000K")[1], (planck[200] + planck[201]) / 2, 1e-12);
  const io::YamlDocument json = json_of(as("json"));
  EXPECT_EQ(numbers(json.root, "wavelength_nm"), (std::vector<double>{450, 560.5, 700}));
  const io::YamlNode& lamps = *io::find(json.root, "lamps");
  ASSERT_EQ(lamps.items.size(), 3u);
  EXPECT_EQ(keys(lamps.items[0]),
            (std::vector<std::string>{"name", "description", "source", "XYZ", "xy", "cct_kelvin", "duv", "power"}));
  EXPECT_NEAR(parse_number(io::find(lamps.items[1], "cct_kelvin")->text).value(), 3000, 1e-3);
  const std::string text = result_of(as("text"));
  for (const char* part : {"CCT 3000 K", "x 0.31273", "wavelength_nm", "560.5", "LED-B3: CIE white LED"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  const std::string wide = result_of({"lamps", "D65", "--observer", "1964", "--wavelengths", "500"});
  EXPECT_NE(wide.find("x 0.31382"), std::string::npos) << wide;
}

TEST(LampTables, AreDrawn) {
  const TemporaryFolder folder;
  const Outcome drawn = run({"lamps", "A", "F11", "-o", "lamps.svg", "-o", "lamps.csv"}, in(folder));
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  const std::string svg = read_all(folder.path() / "lamps.svg");
  for (const char* part : {"<svg", "FL11", "vacuum wavelength (nm)", "radiance per nm"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"lamps.csv", "lamps.svg"}));
}

TEST(LampFiles, TellWhereTheyWereTakenAsZero) {
  const TemporaryFolder folder;
  folder.write("short.csv", "# my lamp\n400,1\n500,3\n700,2\n");
  const Outcome outcome =
      run({"lamps", "file:short.csv", "--wavelengths", "390,450,600", "--format", "csv"}, in(folder));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("warning: lamp 'file:short.csv' is given for 400..700 nm and taken as zero"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.out.find("my lamp"), std::string::npos);
  const io::CsvTable table = *io::parse_csv(outcome.out, "out");
  const std::vector<double> power = column(table, "power");
  EXPECT_EQ(power[0], 0);
  EXPECT_NEAR(power[1] / power[2], 2 / 2.5, 1e-12);
}

// As spreadsheets write them, and in micrometres.
TEST(LampFiles, AreReadInTheirDialects) {
  const TemporaryFolder folder;
  const auto powers_of = [&](const char* text) {
    folder.write("a.csv", text);
    const Outcome outcome = run({"lamps", "file:a.csv", "--wavelengths", "450,600", "--format", "csv"}, in(folder));
    EXPECT_EQ(outcome.exit_code, 0) << text << outcome.err;
    return outcome.exit_code == 0 ? column(*io::parse_csv(outcome.out, "out"), "power") : std::vector<double>();
  };
  const std::vector<double> plain = powers_of("wavelength_nm,power\n400,1.5\n500,3\n700,2.25\n");
  EXPECT_EQ(powers_of("wavelength_nm;power\n400;1,5\n500;3\n700;2,25\n"), plain);
  EXPECT_EQ(powers_of("400,0\t1,5\n500,0\t3\n700,0\t2,25\n"), plain);
  EXPECT_EQ(powers_of("wavelength_um,power\n0.4,1.5\n0.5,3\n0.7,2.25\n"), plain);
}

TEST(LampFiles, ThatAreWrongAreToldAtTheirPlace) {
  const TemporaryFolder folder;
  const struct {
    const char *text, *message;
  } cases[] = {
      {"400,1\n500,x\n", "bad.csv:2:5: error: "},
      {"400,1\n300,1\n", "bad.csv:2:1: error: expected rising wavelengths"},
      {"0,1\n300,1\n", "bad.csv:1:1: error: expected a wavelength > 0 nm"},
      {"wavelength_nm,power\n400,1\n500,-2\n", "bad.csv:3:5: error: expected a power >= 0"},
      {"0.4,1\n0.7,1\n", "bad.csv: error: expected wavelengths in nm; the last one is 0.7: are they micrometres?"},
      {"# mine\nwavelength_nm;power\n400;1,5\n500;x\n", "bad.csv:4:5: error: "},
      {"# mine\nnm,x,y\n400,1,1\n", "bad.csv:2:1: error: expected the columns wavelength_nm"},
      {"nm,x,y\n400,1,1\n", "bad.csv:1:1: error: expected the columns wavelength_nm (or wavelength_um) and power"},
      {"400,1,1\n500,1,1\n", "bad.csv:1:1: error: expected the columns wavelength_nm (or wavelength_um) and power"},
      {"400,0\n500,0\n", "bad.csv: error: the lamp gives no light between 360 and 830 nm"},
      {"900,1\n950,1\n", "bad.csv: error: the lamp gives no light between 360 and 830 nm"},
      {"400,1\n", "bad.csv: error: expected at least two samples, got 1"},
  };
  for (const auto& one : cases) {
    folder.write("bad.csv", one.text);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"lamps", "file:bad.csv"},
          {"color", "air | water 1um | air", "--illuminant", "file:bad.csv"}}) {
      const Outcome outcome = run(command, in(folder));
      EXPECT_EQ(outcome.exit_code, 3) << one.text;
      EXPECT_NE(outcome.err.find(one.message), std::string::npos) << outcome.err << "\n" << one.message;
      EXPECT_EQ(outcome.out, "");
    }
  }
  EXPECT_EQ(run({"lamps", "file:none.csv"}, in(folder)).exit_code, 4);
}

TEST(LampUsage, IsChecked) {
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    const char* message;
  } cases[] = {
      {{"lamps", "D66"}, 3, "did you mean 'D65'?"},
      {{"lamps", "blackbody:10"}, 3, "a temperature from 1000 to 100000 K"},
      {{"lamps", "D65", "--wavelengths", "300:400:1"}, 2, "360"},
      {{"lamps", "--wavelengths", "400"}, 2, "expected the names of lamps"},
      {{"lamps", "--observer", "1964"}, 2, "expected the names of lamps"},
      {{"lamps", "-o", "x.svg"}, 2, "expected the names of lamps"},
      {{"lamps", "D65", "-o", "x.svg", "--format", "csv"}, 2, "--format"},
      {{"lamps", "D65", "-o", "x.exr"}, 2, "x.exr"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << one.arguments.back() << outcome.err;
    EXPECT_NE(outcome.err.find(one.message), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace shabon::test
