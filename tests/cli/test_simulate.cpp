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

TEST_F(Simulate, AFullDiskEndsTheRunWithWhatIsWhole) {
  setting.most_file_bytes = 20000;  // a checkpoint is larger
  const Outcome outcome = simulate("film.yaml -o run --seconds 1 --write cube --cube-edge 8 --quiet");
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "run"))
    EXPECT_NE(entry.path().extension(), ".bin") << entry.path();
}

}  // namespace
}  // namespace shabon::test
