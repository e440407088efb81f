// The code of docs/adding-a-thickness-model.md, compiled as it stands there.
#include <gtest/gtest.h>

#include "tutorial.h"

namespace shabon::film {
namespace {

TEST(Tutorial, AddsAThicknessModelThatWorks) {
  const BandThickness model{100, 700};
  EXPECT_EQ(thickness_nm(model, math::Vec3d{0, 1, 0}), 100);
  EXPECT_EQ(thickness_nm(model, math::Vec3d{0, -1, 0}), 100);
  EXPECT_EQ(thickness_nm(model, math::Vec3d{0.6, 0, 0.8}), 700);
  EXPECT_EQ(about(Of<BandThickness>{}).name, "band");
  EXPECT_EQ(std::tuple_size_v<decltype(fields(Of<BandThickness>{}))>, 2u);
}

}  // namespace
}  // namespace shabon::film
