#include "shabon/film/sphere_map.h"

#include <OpenEXR/ImfEnvmap.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/film/latitude_map.h"
#include "shabon/math/packet.h"

namespace shabon::film {
namespace {

using math::Vec3d;
using Packet = math::packet<double, 8>;

double smooth_nm(const Vec3d& d) { return 500 + 200 * d.y + 90 * d.x * d.z - 40 * std::sin(3 * d.x + d.y); }

Vec3d random_direction(Pcg32& random) {
  const double y = random.uniform(-1, 1), turn = 2 * std::numbers::pi * random.uniform(), r = std::sqrt(1 - y * y);
  return {r * std::cos(turn), y, r * std::sin(turn)};
}

math::Vec3<Packet> together(const Vec3d* d) {
  double x[8], y[8], z[8];
  for (int i = 0; i < 8; ++i) x[i] = d[i].x, y[i] = d[i].y, z[i] = d[i].z;
  return {Packet::load(x), Packet::load(y), Packet::load(z)};
}

// Faces and their turns are those of OpenEXR's cube maps, by its own code.
TEST(SphereMap, stands_as_the_cube_maps_of_openexr) {
  constexpr int size = 5;
  const Imath::Box2i window({0, 0}, {size - 1, 6 * size - 1});
  for (int face = 0; face < face_count; ++face)
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const Vec3d d = node_direction(face, column, row, size);
        const Imath::V3f dir(float(d.x), float(d.y), float(d.z));
        Imf::CubeMapFace found;
        Imath::V2f within;
        Imf::CubeMap::faceAndPixelPosition(dir, window, found, within);
        const bool inside = row > 0 && row < size - 1 && column > 0 && column < size - 1;
        if (!inside) continue;  // an edge belongs to several faces
        const Imath::V2f at = Imf::CubeMap::pixelPosition(found, window, within);
        EXPECT_EQ(int(found), face);
        EXPECT_NEAR(at.x, column, 1e-5);
        EXPECT_NEAR(at.y, face * size + row, 1e-5);
      }
}

TEST(SphereMap, holds_what_it_was_made_of_at_its_nodes) {
  const SphereMap map = sphere_map(9, smooth_nm);
  for (int face = 0; face < face_count; ++face)
    for (int row = 0; row < 9; ++row)
      for (int column = 0; column < 9; ++column) {
        const Vec3d d = math::normalize(node_direction(face, column, row, 9));
        EXPECT_NEAR(thickness_nm(map, d), smooth_nm(d), 1e-4);
        EXPECT_EQ(map.nm[map.index(face, column, row)], static_cast<float>(smooth_nm(d)));
      }
}

TEST(SphereMap, comes_nearer_with_the_square_of_the_spacing) {
  double before = 0;
  for (const int size : {17, 33, 65}) {
    const SphereMap map = sphere_map(size, smooth_nm);
    Pcg32 random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3d d = random_direction(random);
      worst = std::max(worst, std::abs(thickness_nm(map, d) - smooth_nm(d)));
    }
    if (before > 0) {
      EXPECT_LT(worst, before / 3.4);
    }
    before = worst;
  }
  EXPECT_LT(before, 0.25);
}

// Just left and right of every edge and around every corner.
TEST(SphereMap, has_no_seam) {
  const SphereMap map = sphere_map(8, [](const Vec3d& d) { return 400 + 300 * std::sin(9 * d.x + 7 * d.y * d.z); });
  constexpr double near = 1e-9;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const double other : {-1.0, 1.0})
        for (int i = 0; i <= 64; ++i) {
          const double along = i / 32.0 - 1;
          const auto at = [&](double shift) {
            double c[3];
            c[axis] = side * (1 + shift), c[(axis + 1) % 3] = other * (1 - shift), c[(axis + 2) % 3] = along;
            return thickness_nm(map, Vec3d{c[0], c[1], c[2]});
          };
          EXPECT_NEAR(at(near), at(-near), 1e-4);
        }
}

TEST(SphereMap, gives_packets_what_one_number_gets) {
  const SphereMap map = sphere_map(33, smooth_nm);
  Pcg32 random(2);
  for (int i = 0; i < 500; ++i) {
    Vec3d d[8];
    for (Vec3d& one : d) one = random_direction(random);
    if (i == 0) d[0] = {0, 1, 0}, d[1] = {0, -1, 0}, d[2] = {1, 0, 0}, d[3] = {-1, 1, 1}, d[4] = {1, 1, -1};
    const Packet nm = thickness_nm(map, together(d));
    for (int lane = 0; lane < 8; ++lane) EXPECT_NEAR(nm[lane], thickness_nm(map, d[lane]), 1e-9);
  }
}

TEST(SphereMap, is_finite_where_there_is_no_direction) {
  EXPECT_TRUE(std::isfinite(thickness_nm(sphere_map(4, smooth_nm), Vec3d{0, 0, 0})));
}

TEST(SphereMap, closes_the_seams_of_a_picture) {
  math::Raster raster{4, 24, 1, {}};
  Pcg32 random(3);
  for (int i = 0; i < 4 * 24; ++i) raster.values.push_back(static_cast<float>(random.uniform(100, 900)));
  const Result<SphereMap> map = sphere_map(raster);
  ASSERT_TRUE(map);
  // The corner +x +y +z: nodes of three faces.
  const double corner = (raster.values[3] + raster.values[4 * 8 + 3] + raster.values[4 * 16]) / 3.0;
  EXPECT_NEAR(thickness_nm(*map, Vec3d{1, 1, 1}), corner, 1e-3);
  for (const Vec3d d : {Vec3d{1 + 1e-9, 1, 0.3}, Vec3d{1, 1 + 1e-9, 0.3}})
    EXPECT_NEAR(thickness_nm(*map, d), thickness_nm(*map, Vec3d{1, 1, 0.3}), 1e-4);
  EXPECT_EQ(map->nm[map->index(0, 1, 1)], raster.values[5]);
}

TEST(SphereMap, refuses_pictures_of_another_form) {
  for (const math::Raster& raster : {math::Raster{4, 8, 1, std::vector<float>(32)},
                                     {1, 6, 1, std::vector<float>(6)},
                                     {2, 12, 3, std::vector<float>(72)}})
    EXPECT_FALSE(sphere_map(raster));
}

TEST(SphereMap, mixes_node_by_node) {
  const SphereMap a = sphere_map(3, [](const Vec3d&) { return 100; }), b = sphere_map(3, smooth_nm);
  const SphereMap half = mixed(a, b, 0.25);
  for (std::size_t i = 0; i < half.nm.size(); ++i) EXPECT_NEAR(half.nm[i], 75 + 0.25 * b.nm[i], 1e-4);
}

TEST(LatitudeMap, gives_packets_what_one_number_gets) {
  auto raster = std::make_shared<math::Raster>(math::Raster{64, 32, 1, {}});
  for (int i = 0; i < 64 * 32; ++i)
    raster->values.push_back(static_cast<float>(400 + 100 * std::sin(i % 64 * std::numbers::pi / 32) + i / 64));
  const LatitudeMap map{raster, 1, 1};
  Pcg32 random(4);
  for (int i = 0; i < 500; ++i) {
    Vec3d d[8];
    for (Vec3d& one : d) one = random_direction(random);
    if (i == 0) d[0] = {0, 1, 0}, d[1] = {0, -1, 0}, d[2] = {1, 0, 0}, d[3] = {0, 0, -1};
    const Packet nm = thickness_nm(map, together(d));
    for (int lane = 0; lane < 8; ++lane) EXPECT_NEAR(nm[lane], thickness_nm(map, d[lane]), 1e-3);
  }
  EXPECT_NEAR(thickness_nm(map, Vec3d{0, 1, 0}), 404.9, 0.1);  // not the mean of the first row and the last
}

}  // namespace
}  // namespace shabon::film
