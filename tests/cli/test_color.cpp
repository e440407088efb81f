// color, media and lamps: what they print.
#include <gtest/gtest.h>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/optics/media.h"

namespace shabon::test {
namespace {

const std::string film = "air | water 300nm | air";

TEST(Color, JsonHasExactlyTheKeysOfTheContract) {
  const io::YamlDocument json = json_of({"color", film, "--format", "json"});
  EXPECT_EQ(keys(json.root), (std::vector<std::string>{"XYZ", "xy", "Lab", "linear_srgb", "srgb", "hex", "srgb_mapped",
                                                       "hex_mapped", "in_gamut"}));
}

// Newton's colours of a free film, n = 1.333, under D65, computed by colour-science 0.4.6 from spectra of
// sbyrnes321/tmm; the file says how.
TEST(Color, AgreesWithAnIndependentProgram) {
  const Result<io::CsvTable> films = io::read_csv(SHABON_TEST_DATA "/color/newton_d65.csv");
  ASSERT_TRUE(films.ok());
  const std::pair<const char*, std::vector<std::string>> results[] = {{"XYZ", {"X", "Y", "Z"}},
                                                                      {"linear_srgb", {"linDR", "linDG", "linDB"}}};
  const auto thickness_nm = column(*films, "d_nm"), angle_deg = column(*films, "theta_deg");
  for (std::size_t i = 0; i < films->rows.size(); i += 17) {
    const std::string stack = "air | 1.333 " + format_number(thickness_nm[i]) + "nm | air";
    const io::YamlDocument json =
        json_of({"color", stack, "--angle", format_number(angle_deg[i]), "--illuminant", "d65", "--format", "json"});
    for (const auto& [key, columns] : results)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(numbers(json.root, key).at(c), column(*films, columns[c])[i], 1e-9) << stack << " " << columns[c];
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

// 1.0000000000000002 is 1: roundings of the sums are not outside.
TEST(Color, WhiteUnderTheLampIsInside) {
  for (const char* lamp : {"D65", "A", "E", "FL11"}) {
    const io::YamlDocument white = json_of(
        {"color", "1 | 1 1nm | 1", "--transmitted", "--illuminant", lamp, "--adapt", "bradford", "--format", "json"});
    EXPECT_EQ(io::find(white.root, "in_gamut")->text, "true") << lamp;
  }
}

TEST(Color, SaysWhenTransmittedLightIsAbsorbed) {
  const Outcome metal = run({"color", "air | TiO2 60nm | Ti", "--transmitted"});
  EXPECT_EQ(metal.exit_code, 0);
  EXPECT_NE(metal.err.find("Ti absorbs: transmitted is the light that enters it"), std::string::npos) << metal.err;
  EXPECT_EQ(run({"color", "air | TiO2 60nm | Ti"}).err, "");
  EXPECT_EQ(run({"color", "air | TiO2 60nm | glass", "--transmitted"}).err, "");
}

TEST(Color, SlipsAreUnderstood) {
  EXPECT_NE(run({"color", "air | glass 1mm incoherant | air"}).err.find("did you mean 'incoherent'?"),
            std::string::npos);
  EXPECT_NE(run({"color", "air | Xyzzy 1nm | air"}).err.find("'shabon media' lists them"), std::string::npos);
  const std::string help = run({"color", "--help"}).out;
  EXPECT_NE(help.find("(1000..100000 K)"), std::string::npos);
  EXPECT_NE(help.find("(4000..25000 K)"), std::string::npos);
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

TEST(Color, SeveralAnglesAndSidesAreAList) {
  const std::vector<std::string> arguments = {"color",         film,      "--angle",        "0,60",    "--reflected",
                                              "--transmitted", "--space", "xyY,display p3", "--format"};
  const auto as = [&](const char* format) {
    std::vector<std::string> all = arguments;
    all.emplace_back(format);
    return all;
  };
  const io::YamlDocument json = json_of(as("json"));
  const io::YamlNode* colors = io::find(json.root, "colors");
  ASSERT_NE(colors, nullptr);
  ASSERT_EQ(colors->items.size(), 4u);
  const io::CsvTable csv = table_of(as("csv"));
  EXPECT_EQ(column(csv, "angle_deg"), (std::vector<double>{0, 0, 60, 60}));
  for (std::size_t i = 0; i < 4; ++i) {
    const char* side = i % 2 ? "--transmitted" : "--reflected";
    const io::YamlDocument single =
        json_of({"color", film, "--angle", i < 2 ? "0" : "60", side, "--space", "XYY", "--format", "json"});
    EXPECT_EQ(io::find(colors->items[i], "side")->text, std::string(side).substr(2));
    EXPECT_EQ(numbers(colors->items[i], "XYZ"), numbers(single.root, "XYZ"));
    EXPECT_EQ(numbers(single.root, "XYZ").at(1), column(csv, "Y")[i]);
    EXPECT_EQ(numbers(single.root, "linear_srgb").at(2), column(csv, "linear_b")[i]);
    const std::vector<double> xyY = numbers(*io::find(*io::find(single.root, "spaces"), "xyY"), "values");
    EXPECT_EQ(xyY.at(0), numbers(single.root, "xy").at(0));
    EXPECT_EQ(xyY.at(0), column(csv, "xyY_x")[i]);
    const io::YamlNode* p3 = io::find(*io::find(colors->items[i], "spaces"), "Display P3");
    ASSERT_NE(p3, nullptr);
    EXPECT_EQ(numbers(*p3, "values").at(1), column(csv, "Display_P3_G")[i]);
  }
}

// The whole lamp is the white of an RGB space once it is adapted to it, and is not before.
TEST(Color, AdaptsOnRequest) {
  for (const color::AdaptationEntry& method : color::adaptations()) {
    const io::YamlDocument adapted = json_of({"color", "1 | 1", "--transmitted", "--illuminant", "A", "--adaptation",
                                              std::string(method.name), "--space", "ACEScg", "--format", "json"});
    const io::YamlNode* acescg = io::find(*io::find(adapted.root, "spaces"), "ACEScg");
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(numbers(adapted.root, "linear_srgb").at(c), 1, 1e-12) << method.name;
      EXPECT_NEAR(numbers(*acescg, "values").at(c), 1, 1e-12) << method.name;
    }
    EXPECT_NEAR(numbers(adapted.root, "XYZ").at(0), 1.09849, 1e-4);  // the lamp as it is
  }
  const io::YamlDocument plain = json_of({"color", "1 | 1", "--transmitted", "--illuminant", "A", "--format", "json"});
  EXPECT_GT(numbers(plain.root, "linear_srgb").at(0), 1.5);
}

TEST(Color, KnowsEveryLampAndObserver) {
  const TemporaryFolder folder;
  const std::string file = folder.write("lamp.csv", "wavelength_nm,power\n360,1\n830,1\n").string();
  const auto xyz = [](const std::string& lamp, const std::string& observer) {
    return numbers(json_of({"color", film, "--illuminant", lamp, "--observer", observer, "--format", "json"}).root,
                   "XYZ");
  };
  for (const color::Observer& observer : color::observers()) {
    const std::string name(observer.name);
    EXPECT_EQ(xyz("file:" + file, name), xyz("E", name));  // equal energy
    for (const char* lamp : {"fl11", "LED-B3", "blackbody:3000K", "daylight:6500"})
      EXPECT_GT(xyz(lamp, name).at(1), 0.01) << lamp;
  }
  EXPECT_NE(xyz("D65", "1931"), xyz("D65", "1964"));
}

TEST(Color, GamutMappingIsAChoice) {
  const std::string violet = "air | water 200nm | air";
  const auto text = [&](const std::vector<std::string>& more, const char* key) {
    std::vector<std::string> arguments = {"color", violet, "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return io::find(json_of(arguments).root, key)->text;
  };
  EXPECT_EQ(text({"--gamut", "clip"}, "hex_mapped"), text({}, "hex"));
  EXPECT_NE(text({}, "hex_mapped"), text({}, "hex"));
}

TEST(Color, TheCardShowsEveryColour) {
  const std::string svg = result_of({"color", film, "--angle", "0,20,40,60", "--format", "svg"});
  const io::CsvTable csv = table_of({"color", film, "--angle", "0,20,40,60", "--format", "csv"});
  for (const io::CsvRow& row : csv.rows)
    EXPECT_NE(svg.find("fill=\"" + std::string(row.cells[*csv.column("hex_mapped")].text)), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
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
