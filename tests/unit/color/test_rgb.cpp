#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shabon/color/rgb.h"

namespace {

using namespace shabon::color;

TEST(Srgb, MatrixIsDerivedFromThePrimaries) {
  // Sixteen digits from exact arithmetic on the primaries and the white.
  constexpr Matrix3 exact{Vector3{3.2409699419045213, -1.5373831775700932, -0.4986107602930033},
                          Vector3{-0.9692436362808797, 1.8759675015077204, 0.04155505740717562},
                          Vector3{0.055630079696993635, -0.2039769588889765, 1.0569715142428784}};
  // IEC 61966-2-1 as printed; its own rounding of the inverse differs in the last place.
  constexpr Matrix3 printed{Vector3{3.2406, -1.5372, -0.4986}, Vector3{-0.9689, 1.8758, 0.0415},
                            Vector3{0.0557, -0.2040, 1.0570}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(xyz_to_srgb_matrix[i][j], exact[i][j], 2e-15);
      EXPECT_NEAR(xyz_to_srgb_matrix[i][j], printed[i][j], 5e-4);
    }
  }
}

TEST(Srgb, MatrixReproducesPrimariesAndWhite) {
  const struct {
    LinearRgb rgb;
    Xy xy;
  } corners[] = {{{1, 0, 0}, srgb_red}, {{0, 1, 0}, srgb_green}, {{0, 0, 1}, srgb_blue}, {{1, 1, 1}, srgb_white}};
  for (const auto& corner : corners) {
    const Xyz xyz = linear_srgb_to_xyz(corner.rgb);
    EXPECT_NEAR(chromaticity(xyz).x, corner.xy.x, 1e-15);
    EXPECT_NEAR(chromaticity(xyz).y, corner.xy.y, 1e-15);
    const LinearRgb back = xyz_to_linear_srgb(xyz);
    EXPECT_NEAR(back.r, corner.rgb.r, 1e-14);
    EXPECT_NEAR(back.g, corner.rgb.g, 1e-14);
    EXPECT_NEAR(back.b, corner.rgb.b, 1e-14);
  }
  EXPECT_NEAR(linear_srgb_to_xyz({1, 1, 1}).y, 1, 1e-15);
}

TEST(Srgb, EncodingMatchesTheStandardsFormula) {
  EXPECT_EQ(encode_srgb(0.0), 0);
  EXPECT_EQ(encode_srgb(1.0), 1);
  EXPECT_DOUBLE_EQ(encode_srgb(0.001), 0.01292);
  EXPECT_NEAR(encode_srgb(0.18), 0.46135612950044164, 1e-15);
  EXPECT_NEAR(encode_srgb(0.5), 0.7353569830524495, 1e-15);
  EXPECT_NEAR(decode_srgb(128.0 / 255), 0.21586050011389926, 1e-15);
}

TEST(Srgb, EncodingClips) {
  EXPECT_EQ(encode_srgb(-0.5), 0);
  EXPECT_EQ(encode_srgb(7.0), 1);
  EXPECT_EQ(encode_srgb(std::numeric_limits<double>::infinity()), 1);
  EXPECT_EQ(encode_srgb(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(to_hex(encode_srgb(LinearRgb{-1, 0.5, 2})), "#00bcff");
}

TEST(Srgb, DecodingUndoesEncoding) {
  constexpr double seam = 1e-8;  // the standard's two thresholds do not meet more closely
  for (int i = 0; i <= 100000; ++i) {
    const double value = i / 100000.0;
    EXPECT_NEAR(decode_srgb(encode_srgb(value)), value, seam);
    EXPECT_NEAR(encode_srgb(decode_srgb(value)), value, 13 * seam);
  }
  const LinearRgb colour{0.1, 0.001, 0.9}, back = decode_srgb(encode_srgb(colour));
  EXPECT_NEAR(back.r, colour.r, seam);
  EXPECT_NEAR(back.g, colour.g, seam);
  EXPECT_NEAR(back.b, colour.b, seam);
}

TEST(Srgb, EncodingGrows) {
  double last = -1;
  for (int i = 0; i <= 100000; ++i) {
    const double now = encode_srgb(i / 100000.0);
    EXPECT_GT(now, last);
    last = now;
  }
}

TEST(Srgb, EveryByteComesBack) {
  for (int i = 0; i < 256; ++i) {
    const EncodedRgb encoded{i / 255.0, 0, 1};
    EXPECT_EQ(to_bytes(encode_srgb(decode_srgb(encoded)))[0], i);
  }
  EXPECT_EQ(to_bytes({0.5 / 255, 0.4999 / 255, 254.5 / 255}), (std::array<std::uint8_t, 3>{1, 0, 255}));
  EXPECT_EQ(to_hex({1, 171.0 / 255, 9.0 / 255}), "#ffab09");
}

}  // namespace
