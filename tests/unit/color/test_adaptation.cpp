#include <gtest/gtest.h>

#include <algorithm>

#include "shabon/base/text.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/illuminant.h"

namespace {

using namespace shabon::color;

void expect_near(Xyz a, Xyz b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

class EveryAdaptation : public testing::TestWithParam<AdaptationEntry> {};

TEST_P(EveryAdaptation, IsFoundByItsName) {
  EXPECT_EQ(find_adaptation(shabon::lower(GetParam().name)), GetParam().method);
  EXPECT_EQ(name_of(GetParam().method), GetParam().name);
  EXPECT_FALSE(GetParam().description.empty());
  EXPECT_FALSE(find_adaptation("sharp"));
}

TEST_P(EveryAdaptation, TakesEveryLampsWhiteToTheOther) {
  const Adaptation method = GetParam().method;
  for (const Illuminant& first : illuminants()) {
    for (const Illuminant& second : illuminants()) {
      const Xyz from = white_point(first), to = white_point(second), colour{0.2, 0.12, 0.05};
      expect_near(adapt(from, from, to, method), to, 1e-14);
      expect_near(adapt(adapt(colour, from, to, method), to, from, method), colour, 1e-14);
      expect_near(adapt(colour, from, from, method), colour, 1e-15);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptations, EveryAdaptation, testing::ValuesIn(adaptations().begin(), adaptations().end()),
                         [](const auto& entry) {
                           std::string name(entry.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
