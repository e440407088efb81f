#include "shabon/optics/reference/stack_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {
namespace {

Stack film(double thickness_nm, bool coherent = true) {
  return {Medium(), {{Medium::constant(1.38), thickness_nm, coherent}}, Medium::constant(1.52)};
}

const Incidence incidence = incidence_from(Degrees(30));

TEST(StackModel, CallsTheModel) {
  const auto R_s = [](Interference model) { return model_powers(film(200), model, incidence, 550).R_s; };
  EXPECT_EQ(R_s(Interference::airy), airy(1, 1.38, 1.52, 200, incidence, 550).R_s);
  EXPECT_EQ(R_s(Interference::two_beam), two_beam(1, 1.38, 1.52, 200, incidence, 550).R_s);
  EXPECT_EQ(R_s(Interference::none), without_interference(1, 1.38, 1.52, 200, incidence, 550).R_s);
}

TEST(StackModel, AnIncoherentLayerHasNoPhaseInAnyModel) {
  for (const InterferenceEntry& model : interference_models)
    EXPECT_EQ(model_powers(film(200, false), model.value, incidence, 550).T_p,
              without_interference(1, 1.38, 1.52, 200, incidence, 550).T_p);
}

TEST(StackModel, ABareInterfaceIsTheSameInAllModels) {
  const Stack bare = {Medium(), {}, Medium::constant(1.5)};
  for (const InterferenceEntry& model : interference_models)
    EXPECT_NEAR(model_powers(bare, model.value, {}, 550).R_s, 0.04, 1e-16);
}

Stack two_layers(bool coherent) {
  Stack two = film(150, coherent);
  two.layers.push_back({Medium::constant({2.1, 0.1}), 60});
  return two;
}

TEST(StackModel, AiryTakesAnyStack) {
  const Powers coherent = model_powers(two_layers(true), Interference::airy, incidence, 550);
  const Powers expected = stack_powers(two_layers(true), incidence, 550).powers;
  EXPECT_NEAR(coherent.R_p, expected.R_p, 1e-15);
  EXPECT_NEAR(coherent.T_s, expected.T_s, 1e-15);
  const Powers mixed = model_powers(two_layers(false), Interference::airy, incidence, 550);
  EXPECT_EQ(mixed.R_p, stack_powers(two_layers(false), incidence, 550).powers.R_p);
  EXPECT_GT(std::abs(mixed.R_p - coherent.R_p), 1e-3);
}

TEST(StackModel, OnlyAiryTakesSeveralLayers) {
  for (const InterferenceEntry& model : interference_models) {
    EXPECT_TRUE(check_model(film(1), model.value).ok());
    const Status refused = check_model(two_layers(true), model.value);
    EXPECT_EQ(refused.ok(), model.value == Interference::airy) << model.name;
    if (refused.ok()) continue;
    EXPECT_NE(refused.errors()[0].message.find("airy"), std::string::npos);
    EXPECT_NE(refused.errors()[0].message.find(model.name), std::string::npos);
    EXPECT_EQ(refused.errors()[0].failure, Failure::content);
  }
}

}  // namespace
}  // namespace shabon::optics
