// Every model of the list in film/thickness.h is tested as it stands there; a new one is tested once it is listed.
#include "shabon/film/thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace shabon::film {
namespace {

using math::Vec3d;

const std::vector<Vec3d> directions = {{0, 1, 0},     {0, -1, 0},     {1, 0, 0},         {0, 0, -1},
                                       {0.6, 0.8, 0}, {0, -0.6, 0.8}, {0.48, 0.6, 0.64}, {-0.8, 0, 0.6}};

template <std::size_t I = 0, class Visit>
void for_each_model(const Visit& visit) {
  if constexpr (I < std::variant_size_v<ThicknessModel>) {
    visit(std::variant_alternative_t<I, ThicknessModel>{});
    for_each_model<I + 1>(visit);
  }
}

// Each parameter set to `value`.
template <class Model>
Model with_all(Model model, double value) {
  std::apply([&](const auto&... field) { ((model.*field.member = value), ...); }, fields(Of<Model>{}));
  return model;
}

// Four numbers at once, as the renderer's packets behave.
struct FourNumbers {
  double lanes[4];
  FourNumbers(double value) : lanes{value, value, value, value} {}
  FourNumbers(double a, double b, double c, double d) : lanes{a, b, c, d} {}
  [[maybe_unused]] friend FourNumbers operator+(FourNumbers a, FourNumbers b) {
    for (int i = 0; i < 4; ++i) a.lanes[i] += b.lanes[i];
    return a;
  }
  [[maybe_unused]] friend FourNumbers operator-(FourNumbers a, FourNumbers b) {
    for (int i = 0; i < 4; ++i) a.lanes[i] -= b.lanes[i];
    return a;
  }
  [[maybe_unused]] friend FourNumbers operator*(FourNumbers a, FourNumbers b) {
    for (int i = 0; i < 4; ++i) a.lanes[i] *= b.lanes[i];
    return a;
  }
};

TEST(ThicknessModels, are_named_and_documented_once) {
  std::set<std::string_view> names;
  for_each_model([&](auto model) {
    using Model = decltype(model);
    constexpr About told = about(Of<Model>{});
    EXPECT_FALSE(told.name.empty());
    EXPECT_TRUE(told.doc.ends_with('.')) << told.name;
    EXPECT_TRUE(names.insert(told.name).second) << told.name;
    const auto is_documented = [](const auto& field) { EXPECT_FALSE(field.info.doc.empty()) << field.key; };
    std::apply([&](const auto&... field) { (is_documented(field), ...); }, fields(Of<Model>{}));
  });
}

TEST(ThicknessModels, carry_the_unit_in_the_key) {
  for_each_model([&](auto model) {
    const auto has_unit = [](const auto& field) {
      const bool named = field.info.unit.empty() || field.key.ends_with("_" + std::string(field.info.unit));
      EXPECT_TRUE(named) << field.key;
    };
    std::apply([&](const auto&... field) { (has_unit(field), ...); }, fields(Of<decltype(model)>{}));
  });
}

TEST(ThicknessModels, stay_in_range_over_the_sphere) {
  for_each_model([&](auto model) {
    for (double value : {thickness_range_nm.low, 400.0, thickness_range_nm.high}) {
      const ThicknessModel chosen = with_all(model, value);
      for (const Vec3d& direction : directions) {
        const double nm = thickness_nm(chosen, direction);
        EXPECT_TRUE(thickness_range_nm.contains(nm)) << about(Of<decltype(model)>{}).name << ": " << nm;
      }
    }
  });
}

TEST(ThicknessModels, give_each_of_many_numbers_what_one_gets) {
  for_each_model([&](auto model) {
    for (std::size_t i = 0; i + 3 < directions.size(); ++i) {
      const Vec3d* d = &directions[i];
      const math::Vec3<FourNumbers> four{
          {d[0].x, d[1].x, d[2].x, d[3].x}, {d[0].y, d[1].y, d[2].y, d[3].y}, {d[0].z, d[1].z, d[2].z, d[3].z}};
      const FourNumbers together = thickness_nm(ThicknessModel(model), four);
      for (int k = 0; k < 4; ++k) EXPECT_EQ(together.lanes[k], thickness_nm(model, d[k]));
    }
  });
}

TEST(ConstantThickness, is_the_same_everywhere) {
  for (const Vec3d& direction : directions) EXPECT_EQ(thickness_nm(ConstantThickness{321.5}, direction), 321.5);
}

TEST(LinearThickness, grows_from_top_to_bottom) {
  const LinearThickness model{150, 900};
  EXPECT_DOUBLE_EQ(thickness_nm(model, Vec3d{0, 1, 0}), 150);
  EXPECT_DOUBLE_EQ(thickness_nm(model, Vec3d{0, -1, 0}), 900);
  EXPECT_DOUBLE_EQ(thickness_nm(model, Vec3d{0.6, 0, 0.8}), 525);
  EXPECT_DOUBLE_EQ(thickness_nm(model, Vec3d{0, 0.6, 0.8}), 150 + 0.2 * 750);
}

}  // namespace
}  // namespace shabon::film
