// animate: a range of frames, each the picture of its time, and the simulated film that runs along.
#include <gtest/gtest.h>

#include <signal.h>

#include "child.h"
#include "shabon/io/image.h"

namespace shabon::test {
namespace {

using Names = std::vector<std::string>;

const std::string scene_text = R"(shabon: 1
image: {width: 24, height: 16}
render: {samples: 2}
environment: {constant: {illuminant: D65}}
objects:
  - bubble: {film: {medium: water, thickness: {THICKNESS}}}
)";

std::string scene_with(const std::string& thickness) {
  std::string text = scene_text;
  return text.replace(text.find("THICKNESS"), 9, thickness);
}

class Animate : public testing::Test {
 protected:
  Animate() {
    setting.folder = folder.path();
    folder.write("flow.yaml", scene_with("flow: {level: 3, initial: {noise: 0.3, swirl_m_s: 0.3}}"));
    folder.write("still.yaml", scene_with("constant_nm: 400"));
  }
  Outcome call(const std::string& line) const { return run(words(line), setting); }
  std::string bytes(const std::string& name) const { return read_all(folder.path() / name); }
  std::string pixels(const std::string& name) const {
    const auto image = io::read_png(folder.path() / name);
    EXPECT_TRUE(image.ok()) << name;
    return image ? std::string(image->rgb.begin(), image->rgb.end()) : std::string();
  }
  std::size_t frames(const std::string& name) const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / name))
      count += entry.path().filename().string().starts_with("frame.");
    return count;
  }

  TemporaryFolder folder;
  Setting setting;
};

TEST_F(Animate, RendersTheRunningFilm) {
  const Outcome outcome = call("animate flow.yaml -o out --seconds 0.4 --fps 10");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("wrote 4 frames in 'out'"), std::string::npos) << outcome.err;
  EXPECT_EQ(frames("out"), 4u);
  EXPECT_NE(pixels("out/frame.0000.png"), pixels("out/frame.0003.png"));
}

TEST_F(Animate, ApartOrWholeMakesTheSameFrames) {
  EXPECT_EQ(call("animate flow.yaml -o whole --seconds 0.4 --fps 10 --quiet").exit_code, 0);
  EXPECT_EQ(call("animate flow.yaml -o part --first 3 --last 3 --fps 10 --quiet").exit_code, 0);
  EXPECT_EQ(frames("part"), 1u);
  EXPECT_EQ(bytes("whole/frame.0003.png"), bytes("part/frame.0003.png"));
  std::filesystem::remove(folder.path() / "whole/frame.0002.png");
  const std::string kept = bytes("whole/frame.0001.png");
  EXPECT_EQ(call("animate flow.yaml -o whole --seconds 0.4 --fps 10 --quiet --resume").exit_code, 0);
  EXPECT_EQ(frames("whole"), 4u);
  EXPECT_EQ(bytes("whole/frame.0001.png"), kept);
}

TEST_F(Animate, ARenderShowsTheMomentOfItsTime) {
  EXPECT_EQ(call("animate flow.yaml -o out --first 0 --last 2 --fps 5 --seed 1 --quiet").exit_code, 0);
  EXPECT_EQ(call("render flow.yaml -o now.png --set time_s=0 --quiet").exit_code, 0);
  EXPECT_EQ(call("render flow.yaml -o later.png --set time_s=0.4 --seed 3 --quiet").exit_code, 0);
  EXPECT_EQ(pixels("out/frame.0000.png"), pixels("now.png"));
  EXPECT_EQ(pixels("out/frame.0002.png"), pixels("later.png"));  // a frame's seed is its number further
}

TEST_F(Animate, RefusesWhatCannotBe) {
  EXPECT_EQ(call("animate still.yaml").exit_code, 2);
  EXPECT_EQ(call("animate still.yaml -o out --first 5 --last 4").exit_code, 2);
  EXPECT_EQ(call("animate still.yaml -o out --format exr --movie a.mp4").exit_code, 2);
  EXPECT_EQ(call("animate nothing.yaml -o out").exit_code, 4);
  EXPECT_EQ(call("animate still.yaml -o out --first 0 --last 0 --quiet").exit_code, 0);
  EXPECT_EQ(call("animate still.yaml -o out --first 0 --last 0").exit_code, 2);  // it is there already
  Setting without = setting;
  without.environment = {{"PATH", "/nonexistent"}};
  const Outcome movie = run(words("animate still.yaml -o other --movie a.mp4"), without);
  EXPECT_EQ(movie.exit_code, 4);
  EXPECT_NE(movie.err.find("ffmpeg"), std::string::npos) << movie.err;
  folder.write("elsewhere.yaml", R"(shabon: 1
environment: {constant: {illuminant: D65}}
objects:
  - disk: {radius: 1, surface: {film: {medium: water, thickness: {flow: {level: 3}}}}}
)");
  const Outcome elsewhere = call("render elsewhere.yaml");
  EXPECT_EQ(elsewhere.exit_code, 3);
  EXPECT_NE(elsewhere.err.find("a simulated film is closed"), std::string::npos) << elsewhere.err;
}

TEST_F(Animate, KeepsFinishedFramesWhenInterrupted) {
  setting.signals = {{std::chrono::milliseconds(1200), SIGINT}};
  const Outcome outcome = call("animate still.yaml -o out --seconds 10000 --size 64x48 --samples 8");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("--resume makes the others"), std::string::npos) << outcome.err;
  EXPECT_GT(frames("out"), 0u);
  for (std::size_t i = 0; i < frames("out"); ++i)
    pixels(i < 10 ? "out/frame.000" + std::to_string(i) + ".png" : "out/frame.0009.png");
}

}  // namespace
}  // namespace shabon::test
