// Films with a hole.
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/film/thickness_field.h"
#include "shabon/math/packet_math.h"

namespace shabon::film {
namespace {

using math::Vec3d;

ThicknessField holed(const ThicknessField& film, const Vec3d& axis, double cos_hole) {
  return HoledFilm{HeldField{film}, axis, cos_hole};
}

TEST(HoledFilm, has_no_thickness_in_the_hole) {
  const ThicknessField film = LinearThickness{200, 900}, with_hole = holed(film, {0.6, 0, 0.8}, 0.5);
  for (const double scale : {1.0, 0.3, 7.0})  // directions of any length
    for (const double angle : {0.0, 1.0, 1.04, 1.05, 2.0, 3.14}) {
      const Vec3d at = (Vec3d{0.6, 0, 0.8} * std::cos(angle) + Vec3d{0, 1, 0} * std::sin(angle)) * scale;
      const double whole = thickness_nm(film, at);
      EXPECT_EQ(thickness_nm(with_hole, at), std::cos(angle) > 0.5 ? 0 : whole) << angle;
    }
}

TEST(HoledFilm, gives_packets_what_one_number_gets) {
  using Packet = math::packet<double, 8>;
  const ThicknessField field = holed(holed(LinearThickness{200, 900}, {0, 1, 0}, 0.3), {0, 0, 1}, -0.2);
  double x[8], y[8], z[8], found[8];
  int zeros = 0;
  for (int i = 0; i < 8; ++i) x[i] = std::cos(1.7 * i), y[i] = std::sin(2.3 * i), z[i] = std::sin(5.1 * i);
  thickness_nm(field, math::Vec3<Packet>{Packet::load(x), Packet::load(y), Packet::load(z)}).store(found);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(found[i], thickness_nm(field, Vec3d{x[i], y[i], z[i]})) << i;
    zeros += found[i] == 0;
  }
  EXPECT_GT(zeros, 0);
  EXPECT_LT(zeros, 8);
}

TEST(MeanThickness, is_that_of_the_sphere) {
  EXPECT_NEAR(mean_thickness_nm(ConstantThickness{432}), 432, 1e-9);
  EXPECT_NEAR(mean_thickness_nm(LinearThickness{200, 900}), 550, 1e-3);
  EXPECT_NEAR(mean_thickness_nm(holed(ConstantThickness{400}, {0.6, 0.8, 0}, 0.5)), 300, 0.3);
}

}  // namespace
}  // namespace shabon::film
