// Every folder of scenes/ is rendered small and compared with tests/golden/data/<scene>.exr, a picture with so many
// samples that its own noise is negligible. SHABON_UPDATE_GOLDEN=1 renders the goldens anew; then look at them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "comparison.h"
#include "golden_file.h"
#include "other_scene.h"
#include "shabon/api/shabon.h"
#include "tests/gallery_scene.h"

namespace shabon::test {
namespace {

namespace fs = std::filesystem;

const fs::path golden_folder = fs::path(SHABON_SOURCE_DIR) / "tests" / "golden" / "data";

constexpr int width = 80;  // and as high as the scene's own picture asks for
constexpr int golden_samples = 4096;
constexpr int first_seed = 1001, second_seed = 2002, golden_seed = 3003;

fs::path golden_path(const std::string& scene) { return golden_folder / (scene + ".exr"); }

// GoogleTest's names are made of letters, digits and underscores.
std::string test_name(std::string scene) {
  std::replace_if(
      scene.begin(), scene.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return scene;
}

std::string how_to_make(const std::string& scene) {
  return "make it with\n  SHABON_UPDATE_GOLDEN=1 " SHABON_GOLDEN_TEST " --gtest_filter='*/" + test_name(scene) +
         "'\nand look at the picture before it is committed";
}

// What scatters light is noisier than bubbles are, and is given more samples: by default so many.
int samples_of(const scene::Scene& scene) { return scene.objects.empty() ? 16 : 64; }

Result<scene::Scene> load(const std::string& name, int seed, std::optional<int> samples = {}) {
  static std::map<std::string, scene::Scene> known;  // films run for seconds
  auto found = known.find(name);
  if (found == known.end()) {
    auto scene = gallery_scene(name, width);
    if (!scene) return scene;
    found = known.emplace(name, *std::move(scene)).first;
  }
  scene::Scene scene = found->second;
  scene.render.seed = static_cast<std::uint64_t>(seed);
  scene.render.samples = samples.value_or(samples_of(scene));
  return scene;
}

Result<io::RgbImage> picture(const scene::Scene& scene) {
  render::Sensor sensor(scene.width, scene.height);
  const Result<render::RenderReport> done = render::render(scene, {}, sensor);
  if (!done) return done.errors();
  if (done->dropped_samples > 0) return fail(Failure::internal, "some samples were not finite numbers");
  return render::develop_linear(sensor);
}

Result<io::RgbImage> picture(const std::string& name, int seed, std::optional<int> samples = {}) {
  const Result<scene::Scene> scene = load(name, seed, samples);
  if (!scene) return scene.errors();
  return picture(*scene);
}

class Golden : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (std::getenv("SHABON_UPDATE_GOLDEN") != nullptr) {
      const auto image = picture(GetParam(), golden_seed, golden_samples);
      ASSERT_TRUE(image) << to_text(image.errors());
      fs::create_directories(golden_folder);
      const io::Metadata metadata = {{"scene", "scenes/" + GetParam()},
                                     {"samples", std::to_string(golden_samples)},
                                     {"seed", std::to_string(golden_seed)}};
      const Status written = io::write_exr(golden_path(GetParam()), *image, metadata);
      ASSERT_TRUE(written) << to_text(written.errors());
    }
    const auto golden = read_golden(golden_path(GetParam()));
    ASSERT_TRUE(golden) << "there is no golden " << golden_path(GetParam()) << "; " << how_to_make(GetParam());
    const auto scene = load(GetParam(), first_seed);
    ASSERT_TRUE(scene) << to_text(scene.errors());
    ASSERT_EQ(golden->width, scene->width) << how_to_make(GetParam());
    ASSERT_EQ(golden->height, scene->height) << how_to_make(GetParam());
    golden_ = *golden;
  }

  io::RgbImage golden_;
};

TEST_P(Golden, TheSceneIsItsGoldenButForNoise) {
  const auto first = picture(GetParam(), first_seed), second = picture(GetParam(), second_seed);
  ASSERT_TRUE(first) << to_text(first.errors());
  ASSERT_TRUE(second) << to_text(second.errors());
  const Comparison compared = compare(*first, *second, golden_);
  EXPECT_TRUE(compared.agrees()) << compared.text() << "\nIf the change is meant, " << how_to_make(GetParam());
}

// The comparison sees what it is for: the same scene with all films and coatings a little thicker is another picture.
TEST_P(Golden, AFilmThreePerCentThickerIsAnotherPicture) {
  io::RgbImage pictures[2];
  for (const int i : {0, 1}) {
    Result<scene::Scene> scene = load(GetParam(), i == 0 ? first_seed : second_seed);
    ASSERT_TRUE(scene) << to_text(scene.errors());
    if (scale_layers(*scene, 1.03) == 0) {
      ASSERT_GT(stop_dispersion(*scene), 0) << "nothing in the scene makes colours";
    }
    auto image = picture(*scene);
    ASSERT_TRUE(image) << to_text(image.errors());
    pictures[i] = *std::move(image);
  }
  const Comparison compared = compare(pictures[0], pictures[1], golden_);
  EXPECT_FALSE(compared.agrees()) << compared.text();
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(gallery_names()),
                         [](const auto& scene) { return test_name(scene.param); });

TEST(Gallery, EveryGoldenHasItsScene) {
  const std::set<std::string> scenes = gallery_names();
  ASSERT_FALSE(scenes.empty());
  for (const auto& entry : fs::directory_iterator(golden_folder))
    EXPECT_TRUE(scenes.contains(entry.path().stem().string())) << entry.path() << " has no scene";
}

// The gallery shows every scene: a thumbnail, a page with the command that renders it, and a link from the index.
TEST(Gallery, EverySceneIsInTheGallery) {
  const Result<std::string> index = io::read_text_file(gallery_folder / "README.md", 1 << 20);
  ASSERT_TRUE(index) << to_text(index.errors());
  for (const std::string& name : gallery_names()) {
    EXPECT_TRUE(fs::exists(gallery_folder / name / "thumb.png")) << name;
    EXPECT_NE(index->find("(" + name + "/"), std::string::npos) << "scenes/README.md does not link to " << name;
    const Result<std::string> page = io::read_text_file(gallery_folder / name / "README.md", 1 << 20);
    ASSERT_TRUE(page) << to_text(page.errors());
    EXPECT_NE(page->find("shabon render scenes/" + name + "/scene.yaml"), std::string::npos)
        << "scenes/" << name << "/README.md does not say how to render it";
  }
}

}  // namespace
}  // namespace shabon::test
