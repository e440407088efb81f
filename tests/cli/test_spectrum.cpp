// spectrum: what it prints.
#include <gtest/gtest.h>

#include "child.h"
#include "printed.h"
#include "shabon/api/resolvers.h"
#include "shabon/base/text.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::test {
namespace {

const std::string film = "air | water 300nm | air";

optics::Stack stack_of(const std::string& text) { return *optics::parse_stack(text, api::medium_resolver()); }

TEST(Spectrum, PrintsTheReferenceWithAllItsDigits) {
  const std::vector<std::string> names = {"wavelength_nm", "R_s", "R_p", "T_s", "T_p", "A_s", "A_p"};
  for (const auto& model : optics::interference_models) {
    const io::CsvTable table = table_of(
        {"spectrum", "1 | 1.5+0.1i 0.2um | water", "--angle", "40", "--interference", std::string(model.name)});
    EXPECT_EQ(table.columns, names);
    const auto wavelength_nm = column(table, "wavelength_nm"), R_s = column(table, "R_s"), T_p = column(table, "T_p");
    const auto A_p = column(table, "A_p"), R_p = column(table, "R_p");
    ASSERT_EQ(wavelength_nm.size(), 95u);
    EXPECT_EQ(wavelength_nm.front(), 360);
    EXPECT_EQ(wavelength_nm.back(), 830);
    for (std::size_t i = 0; i < wavelength_nm.size(); ++i) {
      const optics::Powers powers = desk::film_powers(stack_of("1 | 1.5+0.1i 200nm | water"), model.value,
                                                      optics::incidence_from(Degrees(40)), wavelength_nm[i]);
      EXPECT_EQ(R_s[i], powers.R_s);
      EXPECT_EQ(T_p[i], powers.T_p);
      EXPECT_EQ(A_p[i], 1 - R_p[i] - T_p[i]);
    }
  }
}

TEST(Spectrum, WritesSeventeenDigits) {
  const optics::Powers powers =
      desk::film_powers(stack_of(film), optics::Interference::airy, optics::incidence_from(Degrees(45)), 400);
  ASSERT_NE(format_exact(powers.T_s), format_number(powers.T_s));  // a value whose shortest form is shorter
  const std::string table = result_of({"spectrum", film, "--angle", "45", "--wavelengths", "400"});
  EXPECT_NE(table.find("," + format_exact(powers.T_s) + ","), std::string::npos) << table;
}

// Films computed by sbyrnes321/tmm 0.2.0 and PyMoosh; the file says how.
TEST(Spectrum, AgreesWithAnIndependentProgram) {
  const Result<io::CsvTable> films = io::read_csv(SHABON_TEST_DATA "/optics/a_film_random.csv");
  ASSERT_TRUE(films.ok());
  const auto n = column(*films, "n"), k = column(*films, "k"), thickness_nm = column(*films, "d_nm");
  const auto angle_deg = column(*films, "theta_deg"), wavelength_nm = column(*films, "lambda_nm");
  for (std::size_t i = 0; i < films->rows.size(); i += 41) {
    const std::string index = format_number(n[i]) + "+" + format_number(k[i]) + "i";
    const std::string stack = "1 | " + index + " " + format_number(thickness_nm[i]) + "nm | air";
    const io::CsvTable table = table_of(
        {"spectrum", stack, "--angle", format_number(angle_deg[i]), "--wavelengths", format_number(wavelength_nm[i])});
    for (const char* name : {"R_s", "R_p", "T_s", "T_p"})
      EXPECT_NEAR(column(table, name).at(0), column(*films, name)[i], 1e-10) << stack << " " << name;
  }
}

// A bare interface is the film of no thickness that it is the limit of.
TEST(Spectrum, KnowsBareInterfaces) {
  for (const char* angle : {"0", "30", "89"}) {
    const std::string bare = result_of({"spectrum", "air | 2.4+0.5i", "--angle", angle});
    EXPECT_EQ(bare, result_of({"spectrum", "air | 2.4+0.5i 0nm | 2.4+0.5i", "--angle", angle}));
  }
  const io::CsvTable glass = table_of({"spectrum", "1 | 1.5", "--wavelengths", "500"});
  EXPECT_NEAR(column(glass, "R_s").at(0), 0.04, 1e-15);  // ((1.5 - 1)/(1.5 + 1))^2
}

TEST(Spectrum, SeveralAnglesComeFirst) {
  const std::vector<std::string> lists[] = {{"--angle", "0,30,90"}, {"--angle", "0", "--angle", "30,90"}};
  for (const std::vector<std::string>& angles : lists) {
    std::vector<std::string> arguments = {"spectrum", film, "--wavelengths", "500,400.5"};
    arguments.insert(arguments.end(), angles.begin(), angles.end());
    const io::CsvTable table = table_of(arguments);
    EXPECT_EQ(table.columns.front(), "angle_deg");
    EXPECT_EQ(column(table, "angle_deg"), (std::vector<double>{0, 0, 30, 30, 90, 90}));
    EXPECT_EQ(column(table, "wavelength_nm"), (std::vector<double>{500, 400.5, 500, 400.5, 500, 400.5}));
    EXPECT_EQ(column(table, "R_s").back(), 1);
    EXPECT_EQ(column(table, "R_p").back(), 1);
    EXPECT_EQ(column(table, "T_s").back(), 0);
    EXPECT_EQ(column(table, "T_p").back(), 0);
  }
}

TEST(Spectrum, GridsReachTheirEnd) {
  const auto last = [](const std::string& grid) {
    return column(table_of({"spectrum", film, "--wavelengths", grid}), "wavelength_nm");
  };
  EXPECT_EQ(last("400:400.7:0.1").size(), 8u);
  EXPECT_EQ(last("400:400.7:0.1").back(), 400.7);
  EXPECT_EQ(last("380:400:15"), (std::vector<double>{380, 395}));
  EXPECT_EQ(last("500:500:1"), (std::vector<double>{500}));
  EXPECT_EQ(last("500"), (std::vector<double>{500}));
}

TEST(Spectrum, JsonHasTheColumnsOfTheCsv) {
  const std::vector<std::string> arguments = {"spectrum", film, "--angle", "0,60", "--wavelengths", "400:700:50"};
  std::vector<std::string> with_format = arguments;
  with_format.insert(with_format.end(), {"--format", "json"});
  const io::CsvTable csv = table_of(arguments);
  const io::YamlDocument json = json_of(with_format);
  for (const std::string& name : csv.columns) EXPECT_EQ(numbers(json.root, name), column(csv, name)) << name;
  EXPECT_EQ(io::find(json.root, "stack")->text, film);
}

TEST(Spectrum, SvgIsADrawing) {
  const std::vector<std::vector<std::string>> kinds = {{"--angle", "30"},
                                                       {"--angle", "0,60"},
                                                       {"--wavelengths", "500", "--angle", "0,30,60,90"},
                                                       {"--wavelengths", "500"}};
  for (const std::vector<std::string>& kind : kinds) {
    std::vector<std::string> arguments = {"spectrum", film, "--format", "SVG"};
    arguments.insert(arguments.end(), kind.begin(), kind.end());
    const std::string svg = result_of(arguments);
    EXPECT_NE(svg.find("<svg"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
}

TEST(Spectrum, SaysThatPowersDoNotAddUpBehindAnAbsorbingMedium) {
  const Outcome outcome = run({"spectrum", "Ag | 1.5 100nm | 1", "--angle", "30", "--wavelengths", "500"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.rfind("warning: Ag absorbs, and light comes through it", 0), 0u) << outcome.err;
  EXPECT_EQ(run({"spectrum", "glass | 1.3 100nm | Ag", "--wavelengths", "500"}).err, "");
}

TEST(Spectrum, WarnsOnceForEachMediumBeyondItsRange) {
  const Outcome outcome = run({"spectrum", "water | water 300nm | air", "--wavelengths", "100:2000:100"});
  EXPECT_EQ(outcome.exit_code, 0);
  const std::size_t first = outcome.err.find("warning: ");
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning: ", first + 1), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("water"), std::string::npos);
}

TEST(Spectrum, ReadsFilesOfNAndK) {
  const TemporaryFolder folder;
  folder.write("oil.csv", "# made for this test\nwavelength_nm,n,k\n400,1.5,0\n600,1.4,0.2\n");
  folder.write("bare oil.csv", "400,1.5\n600,1.4\n");
  folder.write("oil.yml",
               "REFERENCES: \"made for this test\"\nDATA:\n  - type: tabulated nk\n    data: |\n"
               "        0.4 1.5 0\n        0.6 1.4 0.2\n");
  // Coefficients of water: M. Daimon, A. Masumura, Appl. Opt. 46 (2007) 3811-3820, at 20.0 degrees Celsius.
  folder.write("water.yaml",
               "DATA:\n  - type: formula 2\n    wavelength_range: 0.182 1.129\n    coefficients: 0.0 0.5684027565 "
               "0.005101829712 0.1726177391 0.01821153936 0.02086189578 0.02620722293 0.1130748688 10.69792721\n");
  Setting setting;
  setting.folder = folder.path();
  const auto spectrum = [&](const std::string& medium) {
    const Outcome outcome = run({"spectrum", "air | " + medium + " 300nm | air", "--wavelengths", "450,600"}, setting);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string from_csv = spectrum("file:oil.csv");
  EXPECT_EQ(spectrum("file:oil.yml"), from_csv);
  EXPECT_NE(spectrum("file:\"bare oil.csv\""), from_csv);
  EXPECT_EQ(spectrum("file:water.yaml"), spectrum("water"));
  const Outcome at_450 = run({"spectrum", "air | 1.475+0.05i 300nm | air", "--wavelengths", "450"}, setting);
  EXPECT_EQ(from_csv.substr(0, at_450.out.size()), at_450.out);
}

TEST(Spectrum, RefusesBrokenFilesOfNAndKAtTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"falling.csv", "500,1.5\n400,1.4\n"},
      {"text.csv", "wavelength_nm,n\n400,abc\n"},
      {"negative.csv", "400,1.5,-1\n"},
      {"no_n.csv", "wavelength_nm,k\n400,1\n"},
      {"micrometres.csv", "0.4,1.5\n0.6,1.4\n"},
      {"empty.csv", ""},
      {"no_data.yml", "REFERENCES: x\n"},
      {"odd.yml", "DATA:\n  - type: tabulated nk\n    data: 0.4 1.5\n"},
      {"type.yml", "DATA:\n  - type: magic\n"},
      {"only_k.yml", "DATA:\n  - type: tabulated k\n    data: 0.4 1.5\n"},
      {"broken.yml", "DATA: [\n"},
      {"formula.yml", "DATA:\n  - type: formula 77\n    wavelength_range: 0.4 0.8\n    coefficients: 1 2\n"},
  };
  const TemporaryFolder folder;
  for (const auto& [name, text] : broken) {
    const std::string path = folder.write(name, text).string();
    const Outcome outcome = run({"color", "air | file:" + path + " 300nm | air"});
    EXPECT_EQ(outcome.exit_code, 3) << name << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << name;
  }
}

}  // namespace
}  // namespace shabon::test
