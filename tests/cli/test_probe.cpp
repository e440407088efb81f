// probe: the spectrum along one ray.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "child.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/io/csv.h"
#include "shabon/io/yaml.h"

namespace shabon::test {
namespace {

using Names = std::vector<std::string>;

// A lossless bubble under an even sky: `probe` sees the sky as if the bubble were not there.
const std::string even_scene = R"(shabon: 1
image: {width: 21, height: 11}
environment: {constant: {illuminant: A, scale: 0.2}}
objects:
  - bubble: {film: {medium: water, thickness: {constant_nm: 400}}}
)";
const std::string lamp_scene = R"(shabon: 1
image: {width: 21, height: 11}
environment: {gradient: {up: {illuminant: D65, scale: 1}, down: {illuminant: A, scale: 0.1}}}
objects:
  - bubble: {film: {medium: water, thickness: {linear: {top_nm: 150, bottom_nm: 900}}}}
)";

// Bubbles of these radii inside the one of the scene.
std::string nested(const Names& radii) {
  std::string text;
  for (const std::string& radius : radii)
    text += "  - bubble: {radius: " + radius + ", film: {medium: water, thickness: {constant_nm: 400}}}\n";
  return text;
}

class Probe : public testing::Test {
 protected:
  Probe() {
    setting.folder = folder.path();
    folder.write("even.yaml", even_scene);
    folder.write("lamps.yaml", lamp_scene);
  }
  Outcome probe(Names arguments) const {
    arguments.insert(arguments.begin(), "probe");
    return run(arguments, setting);
  }
  std::string result_of(const Names& arguments) const {
    const Outcome outcome = probe(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  std::vector<double> column(const Names& arguments, std::string_view name) const {
    const Result<io::CsvTable> table = io::parse_csv(result_of(arguments), "output");
    EXPECT_TRUE(table.ok());
    return table ? *io::numbers(*table, name) : std::vector<double>{};
  }
  std::vector<double> json_numbers(const Names& arguments, std::string_view key) const {
    const Result<io::YamlDocument> document = io::parse_yaml(result_of(arguments), "output");
    EXPECT_TRUE(document.ok());
    std::vector<double> values;
    if (document)
      for (const io::YamlNode& item : io::find(document->root, key)->items)
        values.push_back(parse_number(item.text).value_or(NAN));
    return values;
  }

  TemporaryFolder folder;
  Setting setting;
};

TEST_F(Probe, SeesTheSkyThroughALosslessBubble) {
  const color::Spectrum sky = color::lamp_radiance(*color::find_illuminant("A"));
  for (const Names& pixel : {Names{"0", "0"}, Names{"10", "5"}, Names{"12", "8"}}) {
    const Names arguments = {"even.yaml", "--pixel", pixel[0], pixel[1]};
    const auto wavelength_nm = column(arguments, "wavelength_nm"), radiance = column(arguments, "radiance");
    ASSERT_EQ(wavelength_nm.size(), 81u);
    EXPECT_EQ(wavelength_nm.front(), 380);
    EXPECT_EQ(wavelength_nm.back(), 780);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const double background = 0.2 * sky.at(static_cast<std::size_t>(wavelength_nm[i]) - color::first_nm);
      EXPECT_NEAR(radiance[i], background, 1e-5 * background) << wavelength_nm[i];
    }
  }
}

TEST_F(Probe, JsonHasExactlyTheKeysOfTheContract) {
  const Names arguments = {"lamps.yaml", "--pixel", "10", "5", "--format", "json"};
  const Result<io::YamlDocument> document = io::parse_yaml(result_of(arguments), "output");
  ASSERT_TRUE(document.ok());
  Names keys;
  for (const auto& [key, value] : document->root.entries) keys.push_back(key.text);
  EXPECT_EQ(keys, (Names{"wavelength_nm", "radiance", "XYZ", "linear_srgb"}));
  Names csv = arguments;
  csv.resize(4);
  EXPECT_EQ(json_numbers(arguments, "radiance"), column(csv, "radiance"));
}

// A spectrum without a colour needs no more than the wavelengths asked for; the colour needs 471 more.
TEST_F(Probe, FollowsOnlyTheWavelengthsAskedFor) {
  folder.write("nested.yaml", lamp_scene + nested({"0.8", "0.7"}));
  const auto seconds = [&](const std::string& format) {
    const Outcome outcome = probe({"nested.yaml", "--pixel", "12", "6", "--wavelengths", "500", "--format", format});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.processor_seconds;
  };
  const double with_color = seconds("json");
  ASSERT_GT(with_color, 0.05) << "too short to compare";
  EXPECT_LT(seconds("csv"), with_color / 3);
}

// Nested bubbles hand light to and fro for ever more branches; a plain bubble does not, and nothing is said.
TEST_F(Probe, SaysWhenTheTreeWasCut) {
  folder.write("nested.yaml", lamp_scene + nested({"0.9", "0.8", "0.7", "0.6"}));
  const Outcome outcome = probe({"nested.yaml", "--pixel", "12", "6", "--wavelengths", "500"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.find("note: not every reflection was followed: branches that carry less than 1e-"), 0u)
      << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(result_of({"lamps.yaml", "--pixel", "12", "6", "--wavelengths", "500"}).find("wavelength_nm"), 0u);
}

TEST_F(Probe, SumsTheWholeRangeForXyz) {
  const Names arguments = {"even.yaml", "--pixel", "10", "5", "--format", "json", "--wavelengths", "500"};
  EXPECT_EQ(json_numbers(arguments, "radiance").size(), 1u);
  EXPECT_NEAR(json_numbers(arguments, "XYZ").at(1), 0.2, 1e-6);
}

TEST_F(Probe, PixelsAreRaysThroughTheirCentres) {
  // The middle of 21 x 11 pixels looks straight ahead.
  const std::string pixel = result_of({"lamps.yaml", "--pixel", "10", "5"});
  EXPECT_EQ(result_of({"lamps.yaml", "--pixel", "10.0", "5e0"}), pixel);
  EXPECT_NE(result_of({"lamps.yaml", "--pixel", "10", "5.4"}), pixel);
  const auto by_pixel = column({"lamps.yaml", "--pixel", "10", "5"}, "radiance");
  const auto by_ray = column({"lamps.yaml", "--ray", "0", "0", "5", "0", "0", "-2"}, "radiance");
  ASSERT_EQ(by_pixel.size(), by_ray.size());
  for (std::size_t i = 0; i < by_pixel.size(); ++i) EXPECT_NEAR(by_pixel[i], by_ray[i], 1e-12);
}

TEST_F(Probe, TakesNegativeNumbersOfEveryForm) {
  const std::string plain = result_of({"lamps.yaml", "--ray", "0", "-0.5", "5", "0", "0", "-1"});
  EXPECT_EQ(result_of({"lamps.yaml", "--ray", "0", "-.5", "5", "-0", "0", "-1"}), plain);
  EXPECT_EQ(result_of({"lamps.yaml", "--ray", "0", "-5e-1", "5", "-.0", "0", "-1."}), plain);
}

TEST_F(Probe, HasASceneOfItsOwn) {
  EXPECT_EQ(column({"--pixel", "400", "300", "--wavelengths", "400:700:100"}, "radiance").size(), 4u);
}

TEST_F(Probe, FollowsFlagsOfTheScene) {
  const Names base = {"lamps.yaml", "--pixel", "10", "6"};
  for (const Names& flags : {Names{"--interference", "two-beam"}, Names{"--interference", "none"},
                             Names{"--set", "objects[0].bubble.radius=2"}, Names{"--size", "30x30"}}) {
    Names arguments = base;
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    EXPECT_NE(result_of(arguments), result_of(base)) << flags[1];
  }
}

TEST_F(Probe, LooksThroughThePolariserOfTheCamera) {
  const Names flags = {"--set", "camera.polarizer_deg=30"};
  Names pixel = {"even.yaml", "--pixel", "0", "0"}, ray = {"even.yaml", "--ray", "9", "0", "5", "0", "0", "-1"};
  const auto open = column(pixel, "radiance"), beside = column(ray, "radiance");
  pixel.insert(pixel.end(), flags.begin(), flags.end());
  ray.insert(ray.end(), flags.begin(), flags.end());
  const auto polarised = column(pixel, "radiance");
  for (std::size_t i = 0; i < open.size(); ++i) EXPECT_NEAR(polarised.at(i), open[i] / 2, 1e-12);
  EXPECT_EQ(column(ray, "radiance"), beside);
}

struct Refusal {
  Names arguments;
  int exit_code;
  std::string said;
};
const std::vector<Refusal> refusals = {
    {{"even.yaml"}, 2, "--pixel"},
    {{"even.yaml", "--pixel", "1", "1", "--ray", "0", "0", "5", "0", "0", "-1"}, 2, ""},
    {{"even.yaml", "--pixel", "1"}, 2, "--pixel"},
    {{"even.yaml", "--pixel", "1", "2", "3"}, 2, "unexpected argument '3'"},
    {{"even.yaml", "--pixel", "21", "0"}, 2, "expected X from -0.5 to 20.5 and Y from -0.5 to 10.5, got 21 0"},
    {{"even.yaml", "--pixel", "0", "-1"}, 2, "expected X from -0.5 to 20.5 and Y from -0.5 to 10.5, got 0 -1"},
    {{"even.yaml", "--pixel", "-.5", "-.5"}, 0, ""},
    {{"even.yaml", "--pixel", "20.5", "10.5"}, 0, ""},
    {{"even.yaml", "--pixel", "20.5", "10.51"}, 2, "got 20.5 10.51"},
    {{"even.yaml", "--pixel", "-.51", "0"}, 2, "got -0.51 0"},
    {{"even.yaml", "--pixel", "a", "0"}, 2, "got 'a'"},
    {{"even.yaml", "--ray", "0", "0", "5", "0", "0", "0"}, 2, "direction"},
    {{"even.yaml", "--ray", "0", "0", "5", "0", "0", "nan"}, 2, "got 'nan'"},
    {{"even.yaml", "--ray", "0", "0", "5", "1e200", "0", "1e200"}, 0, ""},
    {{"even.yaml", "--pixel", "0", "0", "--wavelengths", "300:400:10"}, 2, "from 360 to 830 nm"},
    {{"even.yaml", "--pixel", "0", "0", "--format", "svg"}, 2, "unknown value 'svg'"},
    {{"even.yaml", "--pixel", "0", "0", "--tiles", "3"}, 2, "unknown option '--tiles'"},
    {{"missing.yaml", "--pixel", "0", "0"}, 4, "missing.yaml"},
    {{"even.yaml", "--pixel", "0", "0", "--set", "objects[0].bubble.radius=0"}, 3, "radius"},
};

TEST_F(Probe, RefusesWithTheRightCode) {
  for (const Refusal& refusal : refusals) {
    const Outcome outcome = probe(refusal.arguments);
    std::string shown;
    for (const std::string& argument : refusal.arguments) shown += argument + " ";
    EXPECT_EQ(outcome.exit_code, refusal.exit_code) << shown << outcome.err;
    EXPECT_NE(outcome.err.find(refusal.said), std::string::npos) << shown << outcome.err;
    if (refusal.exit_code != 0) {
      EXPECT_EQ(outcome.out, "") << shown;
    }
  }
}

TEST_F(Probe, ReportsAFullStandardOutput) {
  setting.output = Setting::Output::device_full;
  EXPECT_EQ(probe({"even.yaml", "--pixel", "0", "0"}).exit_code, 4);
}

// The library's glass absorbs by a k of about 1e-8: as an outer medium it counts as clear.
// A ray of its own starts anywhere but on a surface; where the camera stands is of no account then.
TEST_F(Probe, RaysStartOffSurfaces) {
  const std::string lamp = "environment: {constant: {illuminant: A, scale: 0.2}}\n";
  folder.write("wall.yaml",
               "shabon: 1\n" + lamp +
                   "objects:\n  - bubble: {film: {medium: soap, thickness: "
                   "{constant_nm: 400}}}\n  - quad: {position: [0, 0, 5], surface: {diffuse: {color: 0.5}}}\n");
  EXPECT_EQ(probe({"wall.yaml", "--pixel", "3", "4"}).exit_code, 3);
  EXPECT_EQ(probe({"wall.yaml", "--ray", "0", "0", "4", "1", "0", "0"}).exit_code, 0);
  const Outcome on_it = probe({"wall.yaml", "--ray", "0.2", "0.3", "5", "1", "0", "0"});
  EXPECT_EQ(on_it.exit_code, 2);
  EXPECT_NE(on_it.err.find("--ray: expected an origin off every surface, got one on objects[1]"), std::string::npos)
      << on_it.err;
  EXPECT_EQ(probe({"wall.yaml", "--ray", "0", "0", "1", "1", "0", "0"}).exit_code, 0);  // on the bubble
}

TEST_F(Probe, ScenesMayLieInGlass) {
  folder.write("glass.yaml", R"(shabon: 1
image: {width: 21, height: 11}
environment: {constant: {illuminant: A, scale: 0.2}}
objects:
  - bubble: {film: {stack: "glass | water 400nm | glass"}}
)");
  const std::vector<double> inside = column({"glass.yaml", "--pixel", "10", "5", "--format", "csv"}, "radiance"),
                            none = column({"even.yaml", "--pixel", "0", "0", "--format", "csv"}, "radiance");
  ASSERT_EQ(inside.size(), none.size());
  for (std::size_t i = 0; i < none.size(); ++i) EXPECT_NEAR(inside[i] / none[i], 1, 1e-6) << i;
  const Outcome absorbing = probe(
      {"glass.yaml", "--set", "objects[0].bubble.film.stack=1.5+1e-4i | water 400nm | 1.5", "--pixel", "10", "5"});
  EXPECT_EQ(absorbing.exit_code, 3) << absorbing.err;
}

}  // namespace
}  // namespace shabon::test
