// Colour spaces and chromatic adaptation against the figures that their authors and other codes publish.
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/color/adaptation.h"
#include "shabon/color/oklab.h"
#include "shabon/color/rgb_space.h"
#include "shabon/color/spaces.h"

namespace {

using namespace shabon::color;

void expect_matrix(const Matrix3& matrix, const Matrix3& published, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(matrix[i][j], published[i][j], tolerance) << i << ", " << j;
}

// Academy S-2014-004, "ACEScg - A working space for CGI render and compositing", ten decimals.
TEST(PublishedSpaces, AcesCgMatrices) {
  expect_matrix(acescg_space.to_xyz(),
                {Vector3{0.6624541811, 0.1340042065, 0.1561876870}, Vector3{0.2722287168, 0.6740817658, 0.0536895174},
                 Vector3{-0.0055746495, 0.0040607335, 1.0103391003}},
                0.6e-10);
  expect_matrix(
      acescg_space.from_xyz(),
      {Vector3{1.6410233797, -0.3248032942, -0.2364246952}, Vector3{-0.6636628587, 1.6153315917, 0.0167563477},
       Vector3{0.0117218943, -0.0082844420, 0.9883948585}},
      0.6e-10);
}

// W3C, CSS Color Module Level 4, sample code for colour conversions: double precision from the same primaries.
TEST(PublishedSpaces, DisplayP3AndRec2020Matrices) {
  expect_matrix(display_p3_space.from_xyz(),
                {Vector3{2.493496911941425, -0.9313836179191239, -0.40271078445071684},
                 Vector3{-0.8294889695615747, 1.7626640603183463, 0.023624685841943577},
                 Vector3{0.03584583024378447, -0.07617238926804182, 0.9568845240076872}},
                1e-14);
  expect_matrix(rec2020_space.to_xyz(),
                {Vector3{0.6369580483012914, 0.14461690358620832, 0.1688809751641721},
                 Vector3{0.2627002120112671, 0.6779980715188708, 0.05930171646986196},
                 Vector3{0, 0.028072693049087428, 1.060985057710791}},
                1e-14);
}

// ITU-R BT.2020-2, table 4: alpha = 1.0993 and beta = 0.0181 for twelve bits; the parts meet in value and slope.
TEST(PublishedSpaces, Rec2020Transfer) {
  constexpr double alpha = 1.0993, beta = 0.0181, twelve_bits = 0.5 / 4095;
  for (const double e : {0.0, 0.01, 0.03, 0.18, 0.5, 1.0})
    EXPECT_NEAR(encode_bt2020(e), e < beta ? 4.5 * e : alpha * std::pow(e, 0.45) - (alpha - 1), twelve_bits) << e;
  constexpr double seam = 0.018053968510807, step = 1e-6;
  EXPECT_NEAR(encode_bt2020(seam + 1e-15), encode_bt2020(seam - 1e-15), 1e-13);
  EXPECT_NEAR((encode_bt2020(seam + step) - encode_bt2020(seam)) / step, 4.5, 2e-4);
}

// B. Ottosson (2020), table of examples, three decimals.
TEST(PublishedSpaces, OklabExamples) {
  const struct {
    Xyz xyz;
    Vector3 lab;
  } examples[] = {{{0.950, 1.000, 1.089}, {1.000, 0.000, 0.000}},
                  {{1.000, 0.000, 0.000}, {0.450, 1.236, -0.019}},
                  {{0.000, 1.000, 0.000}, {0.922, -0.671, 0.263}},
                  {{0.000, 0.000, 1.000}, {0.153, -1.415, -0.449}}};
  for (const auto& example : examples) {
    const auto lab = from_xyz(ColorSpace::Oklab, example.xyz, {});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(lab[k], example.lab[k], 0.0011);
  }
}

// colour-science (BSD-3-Clause), tests of colour.adaptation.vonkries and the examples of its documentation.
TEST(PublishedAdaptation, MatricesOfAnIndependentCode) {
  constexpr double printed = 0.6e-7;
  const Xyz a{1.09846607, 1, 0.35582280}, d65{0.95042855, 1, 1.08890037};
  expect_matrix(adaptation_matrix(a, d65, Adaptation::cat02),
                {Vector3{0.86876537, -0.14165393, 0.38719611}, Vector3{-0.10300724, 1.05840142, 0.15386462},
                 Vector3{0.00781674, 0.02678750, 2.96081771}},
                printed);
  expect_matrix(adaptation_matrix(a, d65, Adaptation::bradford),
                {Vector3{0.84467949, -0.11793553, 0.39489408}, Vector3{-0.13664085, 1.10412369, 0.12919812},
                 Vector3{0.07986716, -0.13493155, 3.19288296}},
                printed);
  expect_matrix(adaptation_matrix(a, d65, Adaptation::von_kries),
                {Vector3{0.93949221, -0.23393727, 0.42820614}, Vector3{-0.02569635, 1.02638463, 0.00517656},
                 Vector3{0, 0, 3.06023214}},
                printed);
  expect_matrix(adaptation_matrix(a, d65, Adaptation::xyz_scaling),
                {Vector3{0.86523251, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 3.06023214}}, printed);
}

// C. Li et al., Color Res. Appl. 42 (2017) 703, prints the inverse of the matrix of CAT16.
TEST(PublishedAdaptation, InverseOfCat16) {
  for (const AdaptationEntry& entry : adaptations()) {
    if (entry.method != Adaptation::cat16) continue;
    expect_matrix(inverse(entry.xyz_to_cones),
                  {Vector3{1.86206786, -1.01125463, 0.14918677}, Vector3{0.38752654, 0.62144744, -0.00897398},
                   Vector3{-0.01584150, -0.03412294, 1.04996444}},
                  0.6e-8);
  }
}

// B. Lindbloom, "Chromatic Adaptation", http://www.brucelindbloom.com: Bradford from D65 to D50, ASTM E308 whites.
TEST(PublishedAdaptation, BradfordFromD65ToD50) {
  expect_matrix(adaptation_matrix({0.95047, 1, 1.08883}, {0.96422, 1, 0.82521}, Adaptation::bradford),
                {Vector3{1.0478112, 0.0228866, -0.0501270}, Vector3{0.0295424, 0.9904844, -0.0170491},
                 Vector3{-0.0092345, 0.0150436, 0.7521316}},
                0.6e-7);
}

}  // namespace
