// color, media and lamps: what they print.
#include <gtest/gtest.h>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
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
