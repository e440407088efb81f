// spectrum, color, media and lamps: what they print.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "child.h"
#include "shabon/api/desk.h"
#include "shabon/api/resolvers.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/io/csv.h"
#include "shabon/io/yaml.h"
#include "shabon/optics/media.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::test {
namespace {

const std::string film = "air | water 300nm | air";

// Runs a command that must succeed without a word.
std::string result_of(const std::vector<std::string>& arguments) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

io::CsvTable table_of(const std::vector<std::string>& arguments) {
  const Result<io::CsvTable> table = io::parse_csv(result_of(arguments), "output");
  EXPECT_TRUE(table.ok());
  return table ? *table : io::CsvTable{};
}

std::vector<double> column(const io::CsvTable& table, std::string_view name) {
  const Result<std::vector<double>> values = io::numbers(table, name);
  EXPECT_TRUE(values.ok()) << name;
  return values ? *values : std::vector<double>{};
}

// Every JSON text is a YAML text.
io::YamlDocument json_of(const std::vector<std::string>& arguments) {
  const Result<io::YamlDocument> document = io::parse_yaml(result_of(arguments), "output");
  EXPECT_TRUE(document.ok());
  return document ? *document : io::YamlDocument{};
}

std::vector<std::string> keys(const io::YamlNode& node) {
  std::vector<std::string> names;
  for (const auto& [key, value] : node.entries) names.push_back(key.text);
  return names;
}

std::vector<double> numbers(const io::YamlNode& node, std::string_view key) {
  std::vector<double> values;
  const io::YamlNode* list = io::find(node, key);
  EXPECT_NE(list, nullptr) << key;
  if (list == nullptr) return values;
  for (const io::YamlNode& item : list->items) values.push_back(parse_number(item.text).value_or(NAN));
  return values;
}

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
      const optics::Powers powers = api::stack_powers(stack_of("1 | 1.5+0.1i 200nm | water"), model.value,
                                                      optics::incidence_from(Degrees(40)), wavelength_nm[i]);
      EXPECT_EQ(R_s[i], powers.R_s);
      EXPECT_EQ(T_p[i], powers.T_p);
      EXPECT_EQ(A_p[i], 1 - R_p[i] - T_p[i]);
    }
  }
}

// Rows of films computed by sbyrnes321/tmm 0.2.0 and checked against PyMoosh.
struct PublishedFilm {
  std::string stack;
  double angle_deg, wavelength_nm, R_s, R_p, T_s, T_p;
};
const std::vector<PublishedFilm> published_films = {
    {"1 | 2.2576890238772407+1.3811737107351245i 116.35285353677902nm | 1", 20.043439909162675, 500.0665139644902,
     0.2929203115649324, 0.2489710441619222, 0.011589930906862002, 0.012865838168198251},
    {"air | 2.7496358218845987 7.897956848362087 nm | vacuum", 73.08932923606619, 698.8277715008185,
     0.38805305644306054, 0.0008424320438968094, 0.6119469435569385, 0.9991575679561018},
    {"1.0 | 1.4695810210223692 0nm | 5.481999999999999+0.28376999999999974i", 70, 405, 0.776535704103236,
     0.09773961226743093, 0.22346429589676414, 0.9022603877325701},
    {"1.0 | 5.481999999999999+0.28376999999999974i", 70, 405, 0.776535704103236, 0.09773961226743093,
     0.22346429589676414, 0.9022603877325701},
};

TEST(Spectrum, AgreesWithAnIndependentProgram) {
  for (const PublishedFilm& p : published_films) {
    const io::CsvTable table = table_of(
        {"spectrum", p.stack, "--angle", format_number(p.angle_deg), "--wavelengths", format_number(p.wavelength_nm)});
    EXPECT_NEAR(column(table, "R_s").at(0), p.R_s, 1e-10) << p.stack;
    EXPECT_NEAR(column(table, "R_p").at(0), p.R_p, 1e-10) << p.stack;
    EXPECT_NEAR(column(table, "T_s").at(0), p.T_s, 1e-10) << p.stack;
    EXPECT_NEAR(column(table, "T_p").at(0), p.T_p, 1e-10) << p.stack;
  }
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
  EXPECT_EQ(last("380:380.3:0.1").size(), 4u);
  EXPECT_EQ(last("380:380.3:0.1").back(), 380.3);
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

TEST(Color, JsonHasExactlyTheKeysOfTheContract) {
  const io::YamlDocument json = json_of({"color", film, "--format", "json"});
  EXPECT_EQ(keys(json.root), (std::vector<std::string>{"XYZ", "xy", "Lab", "linear_srgb", "srgb", "hex", "srgb_mapped",
                                                       "hex_mapped", "in_gamut"}));
}

// Newton's colours of a free film, n = 1.333, under D65: computed by colour-science 0.4.6 from spectra of
// sbyrnes321/tmm, with the official 1 nm tables of the CIE.
struct NewtonColor {
  double thickness_nm, X, Y, Z, linear_r, linear_g, linear_b;
};
const std::vector<NewtonColor> newton_colors = {
    {30, 0.015166236820982709, 0.01611123680276369, 0.024945534504093144, 0.011946061313192239, 0.016560991244383858,
     0.023924097254476154},
    {120, 0.06782634586138907, 0.07284234586422807, 0.055953954882170684, 0.07993730707437588, 0.07323478928382693,
     0.04805676125778632},
    {180, 0.021501989863979252, 0.01606182053728812, 0.005137872332029035, 0.04243233171535446, 0.009504291079672126,
     0.0033505008011318962},
};

TEST(Color, AgreesWithAnIndependentProgram) {
  for (const NewtonColor& c : newton_colors) {
    const std::string stack = "air | 1.333 " + format_number(c.thickness_nm) + "nm | air";
    const io::YamlDocument json = json_of({"color", stack, "--illuminant", "d65", "--format", "json"});
    const std::vector<double> xyz = numbers(json.root, "XYZ"), linear = numbers(json.root, "linear_srgb");
    const double expected[] = {c.X, c.Y, c.Z, c.linear_r, c.linear_g, c.linear_b};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(xyz.at(i), expected[i], 1e-9) << stack;
      EXPECT_NEAR(linear.at(i), expected[i + 3], 1e-9) << stack;
    }
  }
}

TEST(Color, ReflectedAndTransmittedAreTheLamp) {
  for (const color::Illuminant& lamp : color::illuminants()) {
    const std::vector<std::string> arguments = {
        "color", film, "--angle", "50", "--illuminant", std::string(lamp.name), "--format", "json"};
    std::vector<std::string> through = arguments;
    through.push_back("--transmitted");
    const std::vector<double> reflected = numbers(json_of(arguments).root, "XYZ");
    const std::vector<double> transmitted = numbers(json_of(through).root, "XYZ");
    const color::Xyz white = color::white_point(lamp);
    EXPECT_NEAR(reflected.at(0) + transmitted.at(0), white.x, 1e-12);
    EXPECT_NEAR(reflected.at(1) + transmitted.at(1), 1, 1e-12);
    EXPECT_NEAR(reflected.at(2) + transmitted.at(2), white.z, 1e-12);
  }
}

TEST(Color, SaysWhetherTheColourFitsIntoSrgb) {
  const auto in_gamut = [](const std::string& stack) {
    return io::find(json_of({"color", stack, "--format", "json"}).root, "in_gamut")->text;
  };
  EXPECT_EQ(in_gamut("air | water 100nm | air"), "true");
  EXPECT_EQ(in_gamut("air | water 200nm | air"), "false");
  const io::YamlDocument black = json_of({"color", "air | water 0nm | air", "--format", "json"});
  EXPECT_EQ(io::find(black.root, "hex")->text, "#000000");
  EXPECT_EQ(numbers(black.root, "xy"), (std::vector<double>{0, 0}));
}

TEST(Color, TextHasASwatchOnlyWhereItIsWanted) {
  const auto text = [](std::vector<std::pair<std::string, std::string>> environment) {
    Setting setting;
    setting.environment = std::move(environment);
    const Outcome outcome = run({"color", film}, setting);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string code = "\x1b[48;2;";
  EXPECT_EQ(text({{"COLORTERM", "truecolor"}}).find(code), std::string::npos);
  EXPECT_NE(text({{"CLICOLOR_FORCE", "1"}}).find(code), std::string::npos);
  EXPECT_EQ(text({{"CLICOLOR_FORCE", "1"}, {"NO_COLOR", "1"}}).find(code), std::string::npos);
  for (const char* part : {"XYZ", "xy", "Lab", "linear sRGB", "sRGB clipped", "sRGB mapped", "#", "D65"})
    EXPECT_NE(text({}).find(part), std::string::npos) << part;
}

TEST(Listings, NameEveryMediumAndLamp) {
  const std::string media = result_of({"media"}), media_json = result_of({"media", "--format", "json"});
  for (const optics::MediumEntry& entry : optics::media_library()) {
    EXPECT_NE(media.find(entry.name), std::string::npos) << entry.name;
    EXPECT_NE(media.find(entry.medium.source()), std::string::npos) << entry.name;
    EXPECT_NE(media_json.find("\"" + std::string(entry.name) + "\""), std::string::npos) << entry.name;
  }
  const std::string lamps = result_of({"lamps"});
  for (const color::Illuminant& lamp : color::illuminants()) {
    EXPECT_NE(lamps.find(lamp.name), std::string::npos) << lamp.name;
    EXPECT_NE(lamps.find(lamp.source), std::string::npos) << lamp.name;
  }
  EXPECT_EQ(keys(json_of({"lamps", "--format", "json"}).root), (std::vector<std::string>{"lamps", "observers"}));
  EXPECT_EQ(json_of({"media", "--format", "json"}).root.items.size(), optics::media_library().size());
}

}  // namespace
}  // namespace shabon::test
