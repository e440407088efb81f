// Every model of the list in film/thickness.h is tested as it stands there; a new one is tested once it is listed.
#include "shabon/film/thickness_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "shabon/math/packet_math.h"

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

// Each number set to `value`, as far as its range goes.
template <class Model>
Model with_all(Model model, double value) {
  const auto set = [&](const auto& field) {
    if constexpr (std::is_same_v<std::decay_t<decltype(model.*field.member)>, double>)
      model.*field.member = std::clamp(value, field.info.range.low, field.info.range.high);
  };
  std::apply([&](const auto&... field) { (set(field), ...); }, fields(Of<Model>{}));
  return model;
}

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
      std::string ending = "_";  // kg/m^3 is _kg_m3
      for (const char c : field.info.unit)
        if (c != '^') ending += c == '/' || c == ' ' ? '_' : static_cast<char>(std::tolower(c));
      const bool named = field.info.unit.empty() || field.key.ends_with(ending);
      EXPECT_TRUE(named) << field.key;
    };
    std::apply([&](const auto&... field) { (has_unit(field), ...); }, fields(Of<decltype(model)>{}));
  });
}

TEST(ThicknessModels, stay_in_range_over_the_sphere) {
  for_each_model([&](auto model) {
    for (double value : {thickness_range_nm.low, 400.0, thickness_range_nm.high}) {
      const ThicknessField chosen = at_time(with_all(model, value), 0);
      for (const Vec3d& direction : directions) {
        const double nm = thickness_nm(chosen, direction);
        EXPECT_TRUE(thickness_range_nm.contains(nm)) << about(Of<decltype(model)>{}).name << ": " << nm;
      }
    }
  });
}

TEST(ThicknessModels, give_packets_what_one_number_gets) {
  using Packet = math::packet<double, 8>;
  for_each_model([&](auto model) {
    for (const double value : {0.3, 7.0, 400.0}) {
      const ThicknessField field = at_time(with_all(model, value), 3);
      double x[8], y[8], z[8];
      for (std::size_t i = 0; i < 8; ++i) x[i] = directions[i].x, y[i] = directions[i].y, z[i] = directions[i].z;
      const Packet together =
          thickness_nm(field, math::Vec3<Packet>{Packet::load(x), Packet::load(y), Packet::load(z)});
      for (int k = 0; k < 8; ++k) {
        const double alone = thickness_nm(field, directions[static_cast<std::size_t>(k)]);
        EXPECT_NEAR(together[k], alone, 1e-9 * (1 + alone)) << about(Of<decltype(model)>{}).name;
      }
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
