#include "shabon/optics/reference/single_film.h"

#include <gtest/gtest.h>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {
namespace {

Stack film(double thickness_nm, bool coherent = true) {
  return {Medium(), {{Medium::constant(1.38), thickness_nm, coherent}}, Medium::constant(1.52)};
}

const Incidence incidence = incidence_from(Degrees(30));

TEST(SingleFilm, CallsTheModel) {
  const auto R_s = [](Interference model) { return single_film_powers(film(200), model, incidence, 550).R_s; };
  EXPECT_EQ(R_s(Interference::airy), airy(1, 1.38, 1.52, 200, incidence, 550).R_s);
  EXPECT_EQ(R_s(Interference::two_beam), two_beam(1, 1.38, 1.52, 200, incidence, 550).R_s);
  EXPECT_EQ(R_s(Interference::none), without_interference(1, 1.38, 1.52, 200, incidence, 550).R_s);
}

TEST(SingleFilm, AnIncoherentLayerHasNoPhaseInAnyModel) {
  for (const InterferenceEntry& model : interference_models)
    EXPECT_EQ(single_film_powers(film(200, false), model.value, incidence, 550).T_p,
              without_interference(1, 1.38, 1.52, 200, incidence, 550).T_p);
}

TEST(SingleFilm, ABareInterfaceIsTheSameInAllModels) {
  const Stack bare = {Medium(), {}, Medium::constant(1.5)};
  for (const InterferenceEntry& model : interference_models)
    EXPECT_NEAR(single_film_powers(bare, model.value, {}, 550).R_s, 0.04, 1e-16);
}

TEST(SingleFilm, RefusesSeveralLayers) {
  Stack two = film(1);
  two.layers.push_back(two.layers[0]);
  EXPECT_TRUE(check_single_film(film(1), Interference::two_beam).ok());
  EXPECT_FALSE(check_single_film(two, Interference::airy).ok());
  const auto refused = check_single_film(two, Interference::two_beam);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.errors()[0].message.find("airy"), std::string::npos);
}

}  // namespace
}  // namespace shabon::optics
