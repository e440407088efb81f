// animate: a range of frames, each the picture of its time, and the simulated film that runs along.
#include <gtest/gtest.h>

#include <signal.h>

#include <algorithm>
#include <array>
#include <cstdio>

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

TEST_F(Animate, AddsNoFramesOfAnotherScene) {
  const std::string rest = " -o out --seconds 0.2 --fps 10 --resume --quiet";
  EXPECT_EQ(call("animate still.yaml" + rest).exit_code, 0);
  EXPECT_EQ(frames("out"), 2u);
  std::filesystem::remove(folder.path() / "out/frame.0001.png");
  const std::string film = "objects[0].bubble.film.";
  for (const auto& [line, told] :
       {std::pair<std::string, std::string>{"still.yaml --size 32x16", "image.width: 24 in 'out/animation.csv', 32 in"},
        {"still.yaml --samples 3", "render.samples: 2 in"},
        {"still.yaml --set " + film + "thickness.constant_nm=401", film + "thickness.constant_nm: 400 in"},
        {"still.yaml --exposure 1", "--exposure: 0 in"},
        {"still.yaml --start 1", "--start: 0 in"},
        {"still.yaml --seed 7", "render.seed: not given in"},
        {"flow.yaml", film + "thickness.constant_nm: 400 in 'out/animation.csv', not given in"}}) {
    const Outcome other = call("animate " + line + rest);
    EXPECT_EQ(other.exit_code, 2) << line;
    EXPECT_NE(other.err.find("'out' holds frames of another animation: " + told), std::string::npos) << other.err;
  }
  EXPECT_EQ(call("animate still.yaml -o out --first 1 --last 1 --size 32x16").exit_code, 2);
  EXPECT_EQ(frames("out"), 1u);

  folder.write("same.yaml", "# written in another way\n" + scene_with("\"constant_nm\": 4.0e2"));
  const Outcome same = call("animate same.yaml" + rest);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_EQ(frames("out"), 2u);

  folder.write("out/animation.csv", "key,value\nimage.width\n");
  const Outcome damaged = call("animate still.yaml" + rest);
  EXPECT_EQ(damaged.exit_code, 3);
  EXPECT_NE(damaged.err.find("out/animation.csv:2"), std::string::npos) << damaged.err;

  for (const char* name : {"animation.csv", "frame.0001.png"}) std::filesystem::remove(folder.path() / "out" / name);
  const Outcome older = call("animate still.yaml" + rest);
  EXPECT_EQ(older.exit_code, 0);
  EXPECT_NE(older.err.find("holds frames but no animation.csv"), std::string::npos) << older.err;
  EXPECT_EQ(call("animate still.yaml" + rest).err, "");

  for (const char* name : {"frame.0000.png", "frame.0001.png"}) std::filesystem::remove(folder.path() / "out" / name);
  EXPECT_EQ(call("animate flow.yaml" + rest).exit_code, 0);  // an empty folder is anyone's
}

std::string line_with(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  return at == std::string::npos ? "nothing of " + part + " in\n" + text : text.substr(at, text.find('\n', at) - at);
}

TEST_F(Animate, TellsLikeARenderOfFilmsThatBreakOrDry) {
  folder.write("breaks.yaml",
               scene_with("flow: {level: 2, mean_thickness_nm: 300, rupture: {from_nm: 990, to_nm: 1000}}"));
  const Outcome moving = call("animate breaks.yaml -o out --seconds 0.5 --fps 4 --quiet"),
                still = call("render breaks.yaml -o still.png --set time_s=0.25 --quiet");
  const std::string broke = line_with(moving.err, "the film broke at ");
  EXPECT_NE(broke.find("where it was thinner than 99"), std::string::npos) << broke;
  EXPECT_EQ(broke, line_with(still.err, "the film broke at "));

  folder.write("dries.yaml", scene_with("flow: {level: 2, mean_thickness_nm: 100, evaporation: {rate_nm_s: 200}}"));
  const Outcome dries = call("animate dries.yaml -o dry --first 0 --last 2 --fps 4 --quiet"),
                dry = call("render dries.yaml -o dry.png --set time_s=0.5 --quiet");
  const std::string told = line_with(dries.err, "warning: ");
  EXPECT_NE(told.find("the film dries before the end at 0.5 s"), std::string::npos) << told;
  EXPECT_EQ(told, line_with(dry.err, "warning: "));
  EXPECT_EQ(dries.err.find("warning", dries.err.find("warning") + 1), std::string::npos) << dries.err;
}

std::string frame_file(int frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame.%04d.png", frame);
  return name.data();
}

// The first frame that is larger than all before does not fit.
TEST_F(Animate, AFullDiskKeepsTheFramesThatAreWhole) {
  const std::string animate = "animate flow.yaml --seconds 1.2 --fps 10 --size 64x48 --quiet -o ";
  EXPECT_EQ(call(animate + "whole").exit_code, 0);
  const auto size_of = [&](int frame) {
    return std::filesystem::file_size(folder.path() / "whole" / frame_file(frame));
  };
  std::uintmax_t largest = size_of(0);
  int full = 1;
  while (full < 12 && size_of(full) <= largest) ++full;
  ASSERT_LT(full, 12) << "no frame is larger than the first";
  setting.most_file_bytes = largest;
  const Outcome stopped = call(animate + "out");
  EXPECT_EQ(stopped.exit_code, 4) << stopped.err;
  for (const std::string& part : {"out/" + frame_file(full), "wrote " + std::to_string(full) + " frames in 'out'",
                                  std::string("--resume makes the others")})
    EXPECT_NE(stopped.err.find(part), std::string::npos) << stopped.err;
  EXPECT_EQ(frames("out"), static_cast<std::size_t>(full));
  setting.most_file_bytes.reset();
  EXPECT_EQ(call(animate + "out --resume").exit_code, 0);
  for (int frame = 0; frame < 12; ++frame)
    EXPECT_EQ(bytes("whole/" + frame_file(frame)), bytes("out/" + frame_file(frame)));
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
