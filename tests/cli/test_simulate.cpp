// simulate: the frames it writes, going on from any of them, and what it refuses.
#include <gtest/gtest.h>

#include <signal.h>

#include <algorithm>
#include <cmath>

#include "child.h"
#include "printed.h"
#include "shabon/io/texture_image.h"

namespace shabon::test {
namespace {

using std::chrono::milliseconds;
using Names = std::vector<std::string>;

const std::string film_text = R"(shabon: 1
flow:
  level: 3
  mean_thickness_nm: 700
  initial: {noise: 0.3, noise_scale_m: 0.02, swirl_m_s: 0.2}
  evaporation: {}
  regeneration: {}
)";

class Simulate : public testing::Test {
 protected:
  Simulate() {
    setting.folder = folder.path();
    folder.write("film.yaml", film_text);
  }

  Outcome simulate(const std::string& line) const {
    Names arguments = words(line);
    arguments.insert(arguments.begin(), "simulate");
    return run(arguments, setting);
  }
  void expect_fine(const std::string& line) const {
    const Outcome outcome = simulate(line);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void expect_silence(const std::string& line) const {
    const Outcome outcome = simulate(line);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
  }
  std::string bytes(const std::string& name) const { return read_all(folder.path() / name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder.path() / name); }
  io::TextureImage picture(const std::string& name) const {
    const auto read = io::read_texture_image(folder.path() / name);
    EXPECT_TRUE(read.ok()) << name;
    return read ? *read : io::TextureImage{};
  }
  std::vector<double> diagnostics(const std::string& run, const std::string& name) const {
    const auto table = io::read_csv(folder.path() / run / "diagnostics.csv");
    EXPECT_TRUE(table.ok());
    return table ? column(*table, name) : std::vector<double>{};
  }

  TemporaryFolder folder;
  Setting setting;
};

TEST_F(Simulate, WritesFramesOfEveryKind) {
  expect_fine(
      "film.yaml -o run --seconds 0.2 --fps 10 --write lat-long,cube,gltf --write ply,vtk --lat-long-width 64 "
      "--cube-edge 16 "
      "--quiet");
  for (const char* name : {"lat-long.0002.exr", "cube.0002.exr", "gltf.0002.png", "gltf.0002.json", "film.0002.ply",
                           "film.0002.vtk", "checkpoint.0002.bin"})
    EXPECT_TRUE(exists("run/" + std::string(name))) << name;
  EXPECT_FALSE(exists("run/cube.0003.exr"));
  const io::TextureImage lat_long = picture("run/lat-long.0002.exr"), cube = picture("run/cube.0002.exr");
  EXPECT_EQ(lat_long.width, 64);
  EXPECT_EQ(lat_long.height, 32);
  EXPECT_EQ(cube.width, 16);
  EXPECT_EQ(cube.height, 96);
  // Both pictures lie between the extremes of the grid.
  const double thinnest = diagnostics("run", "thinnest_nm").back(), thickest = diagnostics("run", "thickest_nm").back();
  for (const io::TextureImage& image : {lat_long, cube})
    for (const float nm : image.values) {
      EXPECT_GE(nm, thinnest * (1 - 1e-6));
      EXPECT_LE(nm, thickest * (1 + 1e-6));
    }
  // The 16-bit picture is the same thickness, between the ends of its range.
  const io::TextureImage png = picture("run/gltf.0002.png");
  EXPECT_EQ(png.bits, 16);
  const auto [low, high] = std::minmax_element(lat_long.values.begin(), lat_long.values.end());
  for (std::size_t i = 0; i < png.values.size(); ++i)
    EXPECT_NEAR(*low + png.values[i] * (*high - *low), lat_long.values[i], (*high - *low) / 65535);
  EXPECT_NE(bytes("run/gltf.0002.json").find("iridescenceThicknessMaximum"), std::string::npos);
}

TEST_F(Simulate, TellsOneRowAFrameAndLosesNothing) {
  expect_fine("film.yaml -o run --seconds 0.4 --fps 10 --write cube --cube-edge 8 --quiet");
  EXPECT_EQ(diagnostics("run", "frame"), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(diagnostics("run", "time_s").back(), 0.4);
  const auto film = diagnostics("run", "film_m3"), drop = diagnostics("run", "drop_m3"),
             air = diagnostics("run", "evaporated_m3"), surfactant = diagnostics("run", "surfactant");
  EXPECT_GT(air.back(), 0);
  for (std::size_t i = 0; i < film.size(); ++i) {
    EXPECT_NEAR((film[i] + drop[i] + air[i]) / film[0], 1, 1e-12);
    EXPECT_NEAR(surfactant[i], 1, 1e-12);
  }
}

TEST_F(Simulate, GoesOnFromAnyFrameWithTheSameBits) {
  expect_fine("film.yaml -o whole --seconds 0.6 --fps 10 --checkpoint-every 2 --write cube --cube-edge 8 --quiet");
  expect_fine("film.yaml -o parts --seconds 0.3 --fps 10 --checkpoint-every 2 --write cube --cube-edge 8 --quiet");
  expect_fine("-o parts --resume --seconds 0.6 --write cube --cube-edge 8 --quiet");
  for (const char* name : {"cube.0006.exr", "diagnostics.csv", "checkpoint.0006.bin"})
    EXPECT_EQ(bytes("whole/" + std::string(name)), bytes("parts/" + std::string(name))) << name;
  expect_fine("-o parts --resume-from 5 --seconds 0.6 --write cube --cube-edge 8 --quiet");
  EXPECT_EQ(bytes("whole/cube.0006.exr"), bytes("parts/cube.0006.exr"));
  EXPECT_EQ(bytes("whole/diagnostics.csv"), bytes("parts/diagnostics.csv"));
}

TEST_F(Simulate, KeepsWhatWasFinishedWhenInterrupted) {
  setting.signals = {{milliseconds(1500), SIGINT}};
  const Outcome outcome = simulate("film.yaml -o run --seconds 10000 --write cube --cube-edge 8 --set flow.level=4");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("--resume goes on from there"), std::string::npos) << outcome.err;
  const auto frames = diagnostics("run", "frame");
  ASSERT_FALSE(frames.empty());
  setting.signals.clear();
  const std::string until = std::to_string((frames.back() + 2) / 25);
  expect_fine("-o run --resume --write cube --cube-edge 8 --quiet --seconds " + until);
  EXPECT_EQ(diagnostics("run", "frame").size(), frames.size() + 2);
}

TEST_F(Simulate, RefusesWhatCannotBe) {
  folder.write("bad.yaml", "shabon: 1\nflow: {levl: 3, elasticity_n_m: -1, air: [{jet: {speed_m_s: 900}}]}\n");
  const Outcome bad = simulate("bad.yaml -o run");
  EXPECT_EQ(bad.exit_code, 3);
  for (const char* part : {"bad.yaml:2:8: error: flow.levl: unknown key", "flow.elasticity_n_m: expected",
                           "flow.air[0].jet.speed_m_s: expected"})
    EXPECT_NE(bad.err.find(part), std::string::npos) << part << " in\n" << bad.err;
  EXPECT_FALSE(exists("run"));
  EXPECT_EQ(simulate("film.yaml").exit_code, 2);
  EXPECT_EQ(simulate("-o run").exit_code, 2);
  EXPECT_EQ(simulate("film.yaml -o run --write cub").exit_code, 2);
  EXPECT_EQ(simulate("--preset frsh -o run").exit_code, 2);
  EXPECT_EQ(simulate("-o run --resume").exit_code, 4);
  expect_fine("film.yaml -o run --seconds 0.04 --write cube --cube-edge 4 --quiet");
  EXPECT_EQ(simulate("film.yaml -o run").exit_code, 2);
  EXPECT_EQ(simulate("film.yaml -o run --resume").exit_code, 2);
}

TEST_F(Simulate, DamagedCheckpointsAreToldAndNothingIsLost) {
  expect_fine("film.yaml -o run --seconds 0.2 --fps 10 --write cube --cube-edge 4 --quiet");
  std::string checkpoint = bytes("run/checkpoint.0002.bin");
  checkpoint[checkpoint.size() / 2] ^= 1;
  folder.write("run/checkpoint.0002.bin", checkpoint);
  const Outcome outcome = simulate("-o run --resume --seconds 1");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("checkpoint.0002.bin"), std::string::npos) << outcome.err;
  EXPECT_EQ(diagnostics("run", "frame").size(), 3u);
}

TEST_F(Simulate, GoesOnWithoutRowsThatAreLost) {
  const std::string run = "film.yaml -o run --seconds 0.4 --fps 10 --write cube --cube-edge 4 --quiet";
  expect_fine("film.yaml -o whole --seconds 0.6 --fps 10 --write cube --cube-edge 4 --quiet");
  expect_fine(run);
  const std::string rows = bytes("run/diagnostics.csv");
  const auto resumed = [&](const std::string& text) {
    folder.write("run/diagnostics.csv", text);
    const Outcome outcome = simulate("-o run --resume-from 4 --seconds 0.6 --quiet");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  // What a write that was cut off loses is in the checkpoint.
  EXPECT_EQ(resumed(rows.substr(0, rows.size() - 30)), "");
  EXPECT_EQ(bytes("run/diagnostics.csv"), bytes("whole/diagnostics.csv"));

  std::size_t second = rows.find('\n', rows.find('\n') + 1) + 1;
  std::string damaged = rows;
  damaged[second + 4] = 'x';
  const std::string told = resumed(damaged);
  EXPECT_NE(told.find("run/diagnostics.csv:3: warning: expected 17 numbers"), std::string::npos) << told;
  EXPECT_NE(told.find("'run/diagnostics.csv' lacks the rows of frames 1, "), std::string::npos) << told;
  EXPECT_EQ(diagnostics("run", "frame"), (std::vector<double>{0, 2, 3, 4, 5, 6}));

  for (const std::string& nothing : {std::string(), rows.substr(0, 20)}) {
    const std::string lost = resumed(nothing);
    EXPECT_NE(lost.find("lacks the rows of frames 0 to 3, "), std::string::npos) << lost;
    EXPECT_EQ(diagnostics("run", "frame"), (std::vector<double>{4, 5, 6}));
  }
  std::filesystem::remove(folder.path() / "run/diagnostics.csv");
  const Outcome without = simulate("-o run --resume --seconds 0.7 --quiet");
  EXPECT_NE(without.err.find("lacks the rows of frames 0 to 5, "), std::string::npos) << without.err;
  EXPECT_EQ(diagnostics("run", "frame"), (std::vector<double>{6, 7}));
}

TEST_F(Simulate, RefusesATableThatIsNotItsOwn) {
  expect_fine("film.yaml -o run --seconds 0.1 --fps 10 --write cube --cube-edge 4 --quiet");
  folder.write("run/diagnostics.csv", "time,height\n1,2\n");
  const Outcome outcome = simulate("-o run --resume --seconds 1");
  EXPECT_EQ(outcome.exit_code, 3);
  for (const char* part : {"run/diagnostics.csv:1: error: expected the columns 'frame,time_s", "got 'time,height'"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

TEST_F(Simulate, RefusesCheckpointsOfAnotherFilm) {
  const std::string rest = " --seconds 0.2 --fps 10 --checkpoint-every 1 --write cube --cube-edge 4 --quiet";
  expect_fine("film.yaml -o run" + rest);
  for (const auto& [value, told] : {std::pair<std::string, std::string>{"seed=2", "seed: 1 in 'run/film.csv', 2 in"},
                                    {"level=2", "level: 3 in 'run/film.csv', 2 in"},
                                    {"evaporation.top_excess=0.5", "evaporation.top_excess: 0 in"},
                                    {"black_film={}", "black_film: none in 'run/film.csv', not given in"}}) {
    expect_fine("film.yaml -o " + value + rest + " --set flow." + value);
    folder.write("run/checkpoint.0002.bin", bytes(value + "/checkpoint.0002.bin"));
    const Outcome outcome = simulate("-o run --resume --seconds 0.3");
    EXPECT_EQ(outcome.exit_code, 3);
    for (const std::string& part :
         {std::string("run/checkpoint.0002.bin: error: is of another film: " + told), std::string("--resume-from 1")})
      EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  }
  folder.write("run/checkpoint.0002.bin", bytes("run/checkpoint.0001.bin"));
  const Outcome early = simulate("-o run --resume --seconds 0.3");
  EXPECT_EQ(early.exit_code, 3);
  EXPECT_NE(early.err.find("expected the film at 0.2 s, frame 2, got it at 0.1 s"), std::string::npos) << early.err;

  std::filesystem::remove(folder.path() / "run/film.csv");
  const Outcome older = simulate("-o run --resume-from 1 --seconds 0.2 --quiet");
  EXPECT_EQ(older.exit_code, 0) << older.err;
  EXPECT_NE(older.err.find("there is no 'run/film.csv'"), std::string::npos) << older.err;
  EXPECT_TRUE(exists("run/film.csv"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(Simulate, WarnsOnceOfAFilmThatDries) {
  const std::string rest = " --fps 20 --write cube --cube-edge 4 --quiet --set flow.level=2 --set ";
  const std::string thin = "flow.mean_thickness_nm=100";
  const Outcome known =
      simulate("film.yaml -o known --seconds 0.6" + rest + thin + " --set flow.evaporation.rate_nm_s=200");
  EXPECT_EQ(count(known.err, "warning"), 1u) << known.err;
  for (const char* part : {"the film dries before the end at 0.6 s", "0.5 s for 100 nm", "from about 0.35 s on",
                           "lower evaporation.rate_nm_s", "give rupture"})
    EXPECT_NE(known.err.find(part), std::string::npos) << part << " in\n" << known.err;
  const Outcome seen = simulate("film.yaml -o seen --seconds 2" + rest + thin +
                                " --set flow.evaporation.rate_nm_s=0 --set flow.regeneration.ratio=0.5 --set "
                                "flow.regeneration.patch_radius_m=0.02 --set flow.regeneration.rate_per_s=200");
  EXPECT_EQ(count(seen.err, "warning"), 1u) << seen.err;
  for (const char* part : {"the film is dry at ", "thinner than 30 nm", "lower regeneration.rate_per_s"})
    EXPECT_NE(seen.err.find(part), std::string::npos) << part << " in\n" << seen.err;
  expect_silence("film.yaml -o wet --seconds 0.2" + rest + thin);
}

TEST_F(Simulate, TellsWhatThePicturesRangeLeavesOut) {
  const std::string rest = " --seconds 0.2 --fps 10 --write gltf --lat-long-width 32 --quiet --png-range ";
  const Outcome narrow = simulate("film.yaml -o narrow" + rest + "650 700");
  EXPECT_EQ(narrow.exit_code, 0);
  EXPECT_EQ(count(narrow.err, "warning"), 1u) << narrow.err;
  EXPECT_NE(narrow.err.find("% of the film, at "), std::string::npos) << narrow.err;
  const std::size_t advice = narrow.err.rfind("--png-range ");
  ASSERT_NE(advice, 0u);
  const std::string range = narrow.err.substr(advice + 12, narrow.err.find(" holds", advice) - advice - 12);
  expect_silence("film.yaml -o wide" + rest + range);
}

TEST_F(Simulate, WritesTheIndexOfTheLiquid) {
  const std::string rest = " --seconds 0.04 --write gltf --lat-long-width 32 --quiet";
  expect_fine("film.yaml -o soap" + rest);
  EXPECT_NE(bytes("soap/gltf.0001.json").find("\"iridescenceIor\": 1.33"), std::string::npos);
  expect_fine("film.yaml -o other" + rest + " --medium 1.5");
  expect_fine("-o other --resume --seconds 0.08 --quiet");
  for (const char* name : {"other/gltf.0001.json", "other/gltf.0002.json"})
    EXPECT_NE(bytes(name).find("\"iridescenceIor\": 1.5"), std::string::npos) << bytes(name);
  EXPECT_EQ(simulate("film.yaml -o none --medium sope").exit_code, 3);
}

// The table grows with the run, until it does not fit.
TEST_F(Simulate, ADiskThatFillsUpCostsNothingThatIsWhole) {
  const std::string film = "film.yaml --seconds 2 --fps 10 --write cube --cube-edge 4 --quiet --set flow.level=1 -o ";
  expect_fine(film + "whole");
  setting.most_file_bytes = std::filesystem::file_size(folder.path() / "whole/checkpoint.0020.bin") + 10;
  const Outcome outcome = simulate(film + "run");
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  for (const char* part : {"run/diagnostics.csv", "frames 0 to ", "--resume goes on from there"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_GT(diagnostics("run", "frame").size(), 3u);
  setting.most_file_bytes.reset();
  expect_fine("-o run --resume --seconds 2 --quiet");
  for (const char* name : {"diagnostics.csv", "cube.0020.exr", "checkpoint.0020.bin"})
    EXPECT_EQ(bytes("whole/" + std::string(name)), bytes("run/" + std::string(name))) << name;
}

TEST_F(Simulate, AFullDiskEndsTheRunWithWhatIsWhole) {
  setting.most_file_bytes = 20000;  // a checkpoint is larger
  const Outcome outcome = simulate("film.yaml -o run --seconds 1 --write cube --cube-edge 8 --quiet");
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "run"))
    EXPECT_NE(entry.path().extension(), ".bin") << entry.path();
  EXPECT_NE(outcome.err.find("no frame is complete in 'run'"), std::string::npos) << outcome.err;
  setting.most_file_bytes.reset();
  expect_fine("film.yaml -o run --seconds 0.04 --write cube --cube-edge 8 --quiet");  // there is nothing to go on from
}

}  // namespace
}  // namespace shabon::test
