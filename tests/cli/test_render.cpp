// render: the pictures it writes, what it refuses, and that nothing is ever half-written.
#include <gtest/gtest.h>

#include <signal.h>

#include <fstream>

#include "child.h"
#include "shabon/api/version.h"
#include "shabon/io/image.h"
#include "shabon/io/yaml.h"

namespace shabon::test {
namespace {

using std::chrono::milliseconds;
using Names = std::vector<std::string>;

const std::string scene_text = R"(shabon: 1
image: {width: 24, height: 16}
render: {samples: 4}
environment: {constant: {illuminant: D65, scale: 0.2}, softboxes: [{direction: [1, 1, 1], half_angle_deg: 30, scale: 3}]}
objects:
  - bubble: {film: {medium: water, thickness: {linear: {top_nm: 150, bottom_nm: 900}}}}
)";

class Render : public testing::Test {
 protected:
  Render() {
    setting.folder = folder.path();
    folder.write("scene.yaml", scene_text);
  }

  Outcome render(Names arguments) const {
    arguments.insert(arguments.begin(), "render");
    return run(arguments, setting);
  }

  // Renders to `name` and returns the bytes of the file.
  std::string bytes(const std::string& name, Names arguments) const {
    arguments.insert(arguments.end(), {"-o", name, "--quiet"});
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err + outcome.out, "");
    return read_all(folder.path() / name);
  }

  io::RgbImage picture(Names arguments) const {
    bytes("picture.exr", std::move(arguments));
    const Result<io::RgbImage> image = io::read_exr(folder.path() / "picture.exr");
    EXPECT_TRUE(image.ok());
    return image ? *image : io::RgbImage{};
  }

  TemporaryFolder folder;
  Setting setting;
};

TEST_F(Render, NamesThePictureAfterTheScene) {
  const Outcome outcome = render({"scene.yaml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("wrote scene.png: 24 x 16, 4 samples a pixel"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.files(), (Names{"scene.png", "scene.yaml"}));
}

TEST_F(Render, HasASceneOfItsOwn) {
  const Outcome outcome = render({"--size", "40x30", "--samples", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(folder.files(), (Names{"bubble.png", "scene.yaml"}));
  const Result<io::Rgb8Image> image = io::read_png(folder.path() / "bubble.png");
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 40);
  EXPECT_EQ(image->height, 30);
}

TEST_F(Render, WritesEveryPictureAskedFor) {
  const Outcome outcome =
      render({"scene.yaml", "-o", "a.png", "-o", "b.EXR", "--output", "c.exr", "--stats", "s.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(folder.files(), (Names{"a.png", "b.EXR", "c.exr", "s.json", "scene.yaml"}));
}

TEST_F(Render, KeepsInThePictureHowItWasMade) {
  for (const char* name : {"a.exr", "a.png"}) {
    const std::string content = bytes(name, {"scene.yaml", "--seed", "4711", "--set", "camera.up=[0,1,0]"});
    for (const std::string& text : {std::string("scene.yaml"), std::string("seed"), std::string("4711"),
                                    std::string("samples"), std::string(version()), std::string("camera.up")})
      EXPECT_NE(content.find(text), std::string::npos) << name << " " << text;
  }
}

TEST_F(Render, SaysSoWhenTheWholePictureIsBlack) {
  // The only lamp faces away.
  std::ofstream(folder.path() / "black.yaml")
      << "shabon: 1\nimage: {width: 8, height: 8}\nrender: {samples: 4}\n"
         "environment: {constant: {illuminant: D65, scale: 0}}\n"
         "objects: [{quad: {rotation_deg: [0, 180, 0], surface: {emitter: {}}}}]\n";
  const Outcome outcome = render({"black.yaml"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("warning: the whole picture is black"), std::string::npos) << outcome.err;
}

TEST_F(Render, GivesTheSameBitsForAnyNumberOfThreads) {
  const std::string one = bytes("a.exr", {"scene.yaml", "--threads", "1"});
  EXPECT_EQ(bytes("a.exr", {"scene.yaml", "--threads", "2"}), one);
  EXPECT_EQ(bytes("a.exr", {"scene.yaml", "--threads", "7"}), one);
  EXPECT_NE(bytes("a.exr", {"scene.yaml", "--seed", "2"}), one);
}

TEST_F(Render, FlagsStandForValuesOfTheFile) {
  const std::vector<std::pair<Names, Names>> pairs = {
      {{"--samples", "2"}, {"--set", "render.samples=2"}},
      {{"--seed", "9"}, {"--set", "render.seed=9"}},
      {{"--size", "10x20"}, {"--set", "image.width=10", "--set", "image.height=20"}},
      {{"--interference", "Two-Beam"}, {"--set", "render.interference=two-beam"}},
      {{"--set", "objects[0].bubble.center=[0,-.5,0]"}, {"--set", "objects[0].bubble.center=[0, -0.5, 0]"}},
  };
  const io::RgbImage plain = picture({"scene.yaml"});
  for (const auto& [flag, value] : pairs) {
    Names with_flag = flag, with_value = value;
    with_flag.insert(with_flag.begin(), "scene.yaml");
    with_value.insert(with_value.begin(), "scene.yaml");
    const io::RgbImage image = picture(with_flag);
    EXPECT_EQ(image.rgb, picture(with_value).rgb) << flag[1];
    EXPECT_NE(image.rgb, plain.rgb) << flag[1];
  }
  EXPECT_EQ(picture({"scene.yaml", "--set", "render.seed=5", "--seed", "1"}).rgb, plain.rgb) << "flags win";
}

TEST_F(Render, ExposureTouchesPngOnly) {
  const io::RgbImage plain = picture({"scene.yaml"});
  EXPECT_EQ(picture({"scene.yaml", "--exposure", "3"}).rgb, plain.rgb);
  bytes("plain.png", {"scene.yaml"});
  bytes("dark.png", {"scene.yaml", "--exposure", "-.5"});
  const auto first = [&](const char* name) { return int{io::read_png(folder.path() / name)->rgb.at(0)}; };
  EXPECT_LT(first("dark.png"), first("plain.png"));
  EXPECT_GT(first("dark.png"), first("plain.png") / 2);
}

TEST_F(Render, ExposureOfTheSceneAndOfTheCommandAddUp) {
  const std::string both = bytes("both.png", {"scene.yaml", "--set", "image.exposure_ev=-1.25", "--exposure", "0.5"});
  bytes("flag.png", {"scene.yaml", "--exposure", "-.75"});
  EXPECT_EQ(io::read_png(folder.path() / "both.png")->rgb, io::read_png(folder.path() / "flag.png")->rgb);
  EXPECT_NE(both.find("exposure_ev"), std::string::npos);
  EXPECT_NE(both.find("-0.75"), std::string::npos);
}

TEST_F(Render, WhiteBalanceTouchesPngOnly) {
  const std::vector<std::string> balanced = {"scene.yaml", "--set", "image.white_balance=A"};
  EXPECT_EQ(picture(balanced).rgb, picture({"scene.yaml"}).rgb);
  const std::string bluer = bytes("bluer.png", balanced);
  EXPECT_NE(bluer.find("white_balance"), std::string::npos);
  bytes("plain.png", {"scene.yaml"});
  const auto first = [&](const char* name) { return int{io::read_png(folder.path() / name)->rgb.at(2)}; };
  EXPECT_GT(first("bluer.png"), first("plain.png"));
}

TEST_F(Render, WritesWhatWasDone) {
  EXPECT_EQ(render({"scene.yaml", "--stats", "s.json", "--quiet"}).exit_code, 0);
  const Result<io::YamlDocument> stats = io::read_yaml(folder.path() / "s.json");
  ASSERT_TRUE(stats.ok());
  const auto value = [&](const char* key) {
    const io::YamlNode* node = io::find(stats->root, key);
    return node ? node->text : "";
  };
  // At least one a pixel and sample; more on the bubble's rim, at most four times as many.
  const int plain = 24 * 16 * 4, traced = std::stoi("0" + value("camera_samples"));
  EXPECT_GE(traced, plain);
  EXPECT_LE(traced, 4 * plain);
  EXPECT_EQ(value("samples_done"), "4");
  EXPECT_EQ(value("interrupted"), "false");
  EXPECT_EQ(value("dropped_samples"), "0");
  for (const char* key : {"seconds", "rays", "film_events", "cut_paths", "seed", "interference", "width", "height"})
    EXPECT_NE(value(key), "") << key;
}

// What is refused, with what code, and what is said. Nothing appears in the folder.
struct Refusal {
  Names arguments;
  int exit_code;
  std::string said;
};
const std::vector<Refusal> refusals = {
    {{"scene.yaml", "-o", "a.jpg"}, 2, "expected a file ending in .png or .exr, got 'a.jpg'"},
    {{"scene.yaml", "-o", "png"}, 2, "expected a file ending in .png or .exr"},
    {{"scene.yaml", "-o", "--quiet"}, 2, "expected a file ending"},
    {{"scene.yaml", "-o"}, 2, "--output"},
    {{"scene.yaml", "-o", "a.png", "b.png"}, 2, "unexpected argument 'b.png'"},
    {{"scene.yaml", "-o", "a.png", "-o", "./a.png"}, 2, "given twice"},
    {{"scene.yaml", "-o", "a.png", "--stats", "a.png"}, 2, "given twice"},
    {{"scene.yaml", "--stats", "scene.yaml"}, 2, "is an input"},
    {{"scene.yaml", "--samples", "0"}, 2, "--samples"},
    {{"scene.yaml", "--samples", "1.5"}, 2, "--samples"},
    {{"scene.yaml", "--samples", "99999999999999999999"}, 2, "--samples"},
    {{"scene.yaml", "--seed", "-1"}, 2, "--seed"},
    {{"scene.yaml", "--threads", "0"}, 2, "--threads"},
    {{"scene.yaml", "--size", "24"}, 2, "expected WxH"},
    {{"scene.yaml", "--size", "0x16"}, 2, "--size"},
    {{"scene.yaml", "--size", "65536x65536"}, 2, "at most 2^28 pixels"},
    {{"list.yaml", "--size", "8x8", "--samples", "1"}, 3, "list.yaml:1:1: error: expected a mapping with keys"},
    {{"scene.yaml", "--exposure", "inf"}, 2, "--exposure"},
    {{"scene.yaml", "--exposure", "1e9"}, 2, "--exposure"},
    {{"scene.yaml", "--interference", "thin"}, 2, "unknown value 'thin'"},
    {{"scene.yaml", "--set", "nonsense"}, 2, "nonsense"},
    {{"scene.yaml", "other.yaml"}, 2, "unexpected argument 'other.yaml'"},
    {{"scene.yaml", "--set", "objects[0].bubble.radius=-1"}, 3, "objects[0].bubble.radius"},
    {{"scene.yaml", "--set", "objects[0].bubble.radios=1"}, 3, "radius"},
    {{"scene.yaml", "--set", "objects[0].bubble.film.medium=watr"}, 3, "did you mean 'water'?"},
    {{"wrong.yaml"}, 3, "wrong.yaml:1:"},
    {{"truncated.yaml"}, 3, "cut.exr"},
    {{"no-picture.yaml"}, 4, "missing.hdr"},
    {{"missing.yaml"}, 4, "missing.yaml"},
    {{"."}, 4, ""},
    {{"scene.yaml", "-o", "no/such/folder/a.png"}, 4, "no/such/folder"},
    {{"scene.yaml", "-o", "folder.png"}, 4, "folder.png"},
    {{"scene.yaml", "--stats", "no/such/folder/s.json"}, 4, "no/such/folder"},
    {{"scene.yaml", "-o", "a.png", "-o", "no/such/folder/a.exr"}, 4, "no/such/folder"},
};

TEST_F(Render, RefusesWithTheRightCodeAndWritesNothing) {
  const std::string environment = "shabon: 1\nenvironment: {image: {file: ";
  folder.write("list.yaml", "- shabon: 1\n");
  folder.write("wrong.yaml", "shabon: 1, camera: [\n");
  folder.write("no-picture.yaml", environment + "missing.hdr}}\nobjects: []\n");
  folder.write("truncated.yaml", environment + "cut.exr}}\nobjects: []\n");
  const std::string whole = bytes("whole.exr", {"scene.yaml"});
  folder.write("cut.exr", whole.substr(0, whole.size() / 2));
  std::filesystem::create_directory(folder.path() / "folder.png");
  const Names before = folder.files();
  for (const Refusal& refusal : refusals) {
    const Outcome outcome = render(refusal.arguments);
    std::string shown;
    for (const std::string& argument : refusal.arguments) shown += argument + " ";
    EXPECT_EQ(outcome.exit_code, refusal.exit_code) << shown << outcome.err;
    EXPECT_NE(outcome.err.find(refusal.said), std::string::npos) << shown << outcome.err;
    EXPECT_EQ(outcome.out, "") << shown;
    EXPECT_EQ(folder.files(), before) << shown;
  }
  EXPECT_EQ(read_all(folder.path() / "scene.yaml"), scene_text);
}

TEST_F(Render, DoesNotOverwriteThePictureItReads) {
  const std::string sky = bytes("sky.exr", {"scene.yaml"});
  folder.write("in-the-sky.yaml", "shabon: 1\nenvironment: {image: {file: sky.exr}}\nobjects: []\n");
  std::filesystem::create_symlink("sky.exr", folder.path() / "link.exr");
  std::filesystem::create_hard_link(folder.path() / "sky.exr", folder.path() / "hard.exr");
  for (const char* output : {"sky.exr", "./sky.exr", "link.exr", "hard.exr"}) {
    const Outcome outcome = render({"in-the-sky.yaml", "--size", "8x8", "--samples", "1", "-o", output});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("is an input"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_all(folder.path() / "sky.exr"), sky);
  }
}

TEST_F(Render, LeavesNothingHalfWrittenWhenTheDiskIsFull) {
  const std::string before = bytes("kept.png", {"scene.yaml"});
  setting.most_file_bytes = 200;
  for (const char* output : {"new.png", "new.exr", "kept.png"}) {
    const Outcome outcome = render({"scene.yaml", "-o", output, "--samples", "1", "--size", "64x64"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find(output), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder.files(), (Names{"kept.png", "scene.yaml"}));
  EXPECT_EQ(read_all(folder.path() / "kept.png"), before);
}

// A picture may have taken hours; that another file cannot be written is no reason to lose it.
TEST_F(Render, KeepsThePictureWhenTheStatisticsCannotBeWritten) {
  for (const Names& quiet : {Names{}, Names{"--quiet"}}) {
    Names arguments = {"scene.yaml", "-o", "new.png", "--stats", "/dev/full"};
    arguments.insert(arguments.end(), quiet.begin(), quiet.end());
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("/dev/full: error: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("complete in spite of this: new.png"), std::string::npos) << outcome.err;
    EXPECT_TRUE(io::read_png(folder.path() / "new.png").ok());
    EXPECT_TRUE(std::filesystem::remove(folder.path() / "new.png"));
  }
  EXPECT_NE(run({"render", "--help"}).out.find("the others still are"), std::string::npos);
}

TEST_F(Render, KeepsWhatIsFinishedWhenInterrupted) {
  using Signals = std::vector<std::pair<milliseconds, int>>;
  const auto soon = milliseconds(20);  // signals sent at once may reach two threads in any order
  const std::vector<std::pair<int, Signals>> kinds = {
      {130, {{{}, SIGINT}}}, {143, {{{}, SIGTERM}}}, {130, {{{}, SIGINT}, {soon, SIGTERM}, {soon, SIGINT}}}};
  for (const auto& [code, signals] : kinds) {
    // Once more, later, when the signal came before the first pass was through.
    for (milliseconds pause(500); pause < milliseconds(40'000); pause *= 3) {
      setting.signals = signals;
      setting.signals.front().first = pause;
      const Outcome outcome =
          render({"scene.yaml", "--samples", "1000000", "-o", "a.png", "-o", "a.exr", "--stats", "a.json"});
      ASSERT_EQ(outcome.exit_code, code) << outcome.err;
      EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
      if (outcome.err.find("nothing is written") != std::string::npos) continue;
      EXPECT_EQ(folder.files(), (Names{"a.exr", "a.json", "a.png", "scene.yaml"}));
      const Result<io::RgbImage> image = io::read_exr(folder.path() / "a.exr");
      ASSERT_TRUE(image.ok());
      EXPECT_EQ(image->width, 24);
      EXPECT_NE(read_all(folder.path() / "a.json").find("\"interrupted\": true"), std::string::npos);
      break;
    }
    EXPECT_TRUE(std::filesystem::remove(folder.path() / "a.png"));
  }
}

}  // namespace
}  // namespace shabon::test
