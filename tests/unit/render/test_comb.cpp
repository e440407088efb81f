// The wavelength combs: exact for the lamps they are made for, and how far a film's colour is from the sum at 1 nm.
#include "shabon/render/comb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "shabon/color/illuminant.h"
#include "shabon/color/rgb_basis.h"
#include "shabon/optics/reference/airy.h"

namespace shabon::render {
namespace {

using color::Spectrum;
using Xyz = std::array<double, 3>;

const color::Observer& observer = color::observer_1931();

Xyz exact_xyz(const Spectrum& radiance) {
  Xyz sum{};
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    sum[0] += radiance[i] * observer.x[i];
    sum[1] += radiance[i] * observer.y[i];
    sum[2] += radiance[i] * observer.z[i];
  }
  return sum;
}

template <class Radiance>
Xyz comb_xyz(const Comb& comb, const Radiance& radiance) {
  Xyz sum{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < lane_count; ++i) sum[c] += comb.weight[c][i] * radiance(comb.wavelength_nm[i]);
  return sum;
}

std::vector<Spectrum> lamps_named(std::initializer_list<const char*> names) {
  std::vector<Spectrum> lamps;
  for (const char* name : names) lamps.push_back(lamp_radiance(*color::find_illuminant(name)));
  return lamps;
}

std::vector<Spectrum> smooth_lamps() { return lamps_named({"D65", "A", "E"}); }

bool has_lines(const color::Illuminant& lamp) { return lamp.name.starts_with("FL"); }

// What a picture shines with: the three basis spectra under D65.
std::vector<Spectrum> picture_lamps() {
  const color::RgbBasis& basis = color::rgb_basis();
  const Spectrum white = lamp_radiance(*color::find_illuminant("D65"));
  std::vector<Spectrum> lamps;
  for (const Spectrum* part : {&basis.r, &basis.g, &basis.b}) {
    lamps.push_back(*part);
    for (std::size_t i = 0; i < white.size(); ++i) lamps.back()[i] *= white[i];
  }
  return lamps;
}

TEST(Comb, CoversTheObserversRange) {
  const auto combs = wavelength_combs(observer, smooth_lamps());
  ASSERT_EQ(combs.size(), static_cast<std::size_t>(comb_count));
  std::vector<double> all;
  for (const Comb& comb : combs) {
    for (std::size_t i = 1; i < lane_count; ++i)
      EXPECT_NEAR(comb.wavelength_nm[i] - comb.wavelength_nm[i - 1], 471.0 / lane_count, 1e-12);
    all.insert(all.end(), comb.wavelength_nm.begin(), comb.wavelength_nm.end());
  }
  std::sort(all.begin(), all.end());
  // Together they are the middles of equal cells from 359.5 to 830.5 nm.
  const double cell_nm = 471.0 / static_cast<double>(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_NEAR(all[i], 359.5 + (static_cast<double>(i) + 0.5) * cell_nm, 1e-9);
}

void expect_exact(const std::vector<Spectrum>& lamps, const char* what) {
  double worst = 0;
  for (const Comb& comb : wavelength_combs(observer, lamps))
    for (const Spectrum& lamp : lamps) {
      const Xyz exact = exact_xyz(lamp), sum = comb_xyz(comb, [&](double nm) { return at_wavelength(lamp, nm); });
      for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(sum[c] - exact[c]));
    }
  std::printf("[ measured ] %-22s %.2g\n", what, worst);
  EXPECT_LT(worst, 1e-12) << what;
}

TEST(Comb, EveryCombIntegratesEveryLampExactly) {
  for (const color::Illuminant& lamp : color::illuminants()) expect_exact({lamp_radiance(lamp)}, lamp.name.c_str());
  expect_exact(smooth_lamps(), "three lamps");
  expect_exact(picture_lamps(), "a picture");
  expect_exact(lamps_named({"D65", "FL11"}), "daylight and lines");
}

// Where a lamp has lines the wavelengths crowd there; together they still stand for the whole range, each nanometre
// once.
TEST(Comb, FollowsLines) {
  for (const char* name : {"FL2", "FL11", "FL3.15", "LED-B5"}) {
    const Spectrum lamp = lamps_named({name})[0];
    const auto combs = wavelength_combs(observer, std::vector<Spectrum>{lamp});
    double near_lines = 0, highest = *std::max_element(lamp.begin(), lamp.end());
    std::vector<double> all;
    for (const Comb& comb : combs) {
      for (std::size_t i = 0; i < lane_count; ++i) {
        if (i > 0) {
          EXPECT_GT(comb.wavelength_nm[i], comb.wavelength_nm[i - 1]) << name;
        }
        near_lines += at_wavelength(lamp, comb.wavelength_nm[i]) > 0.3 * highest;
        all.push_back(comb.wavelength_nm[i]);
      }
    }
    EXPECT_GE(*std::min_element(all.begin(), all.end()), 359.5);
    EXPECT_LE(*std::max_element(all.begin(), all.end()), 830.5);
    double share = 0;
    for (const double power : lamp) share += power > 0.3 * highest;
    EXPECT_GT(near_lines / static_cast<double>(all.size()), 1.5 * share / 471) << name;
  }
}

// More lamps than a comb can serve: the first ones are exact, and nothing runs away.
TEST(Comb, ManyLamps) {
  std::vector<Spectrum> lamps;
  for (const color::Illuminant& lamp : color::illuminants()) lamps.push_back(lamp_radiance(lamp));
  for (const Comb& comb : wavelength_combs(observer, lamps)) {
    for (std::size_t a = 0; a < most_exact_lamps; ++a) {
      const Xyz exact = exact_xyz(lamps[a]),
                sum = comb_xyz(comb, [&](double nm) { return at_wavelength(lamps[a], nm); });
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], exact[c], 1e-4);
    }
    for (const auto& weights : comb.weight)
      for (const double weight : weights) ASSERT_LT(std::abs(weight), 1e5);
  }
}

TEST(Comb, LampsTogetherWithAPicture) {
  std::vector<Spectrum> lamps = smooth_lamps();
  for (const Spectrum& part : picture_lamps()) lamps.push_back(part);
  expect_exact(lamps, "lamps and a picture");
}

// A lamp given twice, or one that is a mixture of others: D65 is the sum of the parts of a white picture.
TEST(Comb, LampsThatDependOnEachOther) {
  std::vector<Spectrum> lamps = picture_lamps();
  lamps.push_back(lamp_radiance(*color::find_illuminant("D65")));
  lamps.push_back(lamps[3]);
  expect_exact(lamps, "dependent lamps");
}

TEST(Comb, AnySizeOfLamp) {
  Spectrum dim = lamp_radiance(*color::find_illuminant("A"));
  for (double& value : dim) value *= 1e-9;
  expect_exact({dim}, "a dim lamp");
  const auto combs = wavelength_combs(observer, std::vector<Spectrum>{Spectrum{}});  // a black one
  ASSERT_EQ(combs.size(), static_cast<std::size_t>(comb_count));
  for (const Comb& comb : combs) {
    double sum = 0;
    for (const double weight : comb.weight[1]) sum += weight;
    ASSERT_TRUE(std::isfinite(sum));
  }
}

TEST(Comb, BetweenTableValuesSpectraAreLines) {
  const Spectrum lamp = smooth_lamps()[0];
  EXPECT_EQ(at_wavelength(lamp, 360), lamp[0]);
  EXPECT_EQ(at_wavelength(lamp, 500), lamp[140]);
  EXPECT_EQ(at_wavelength(lamp, 830), lamp[470]);
  EXPECT_NEAR(at_wavelength(lamp, 500.25), 0.75 * lamp[140] + 0.25 * lamp[141], 1e-15);
  EXPECT_EQ(at_wavelength(lamp, 359.5), lamp[0]);
  EXPECT_EQ(at_wavelength(lamp, 830.5), lamp[470]);
}

struct Bias {
  double all_combs = 0;  // of the mean over all combs: what a converged picture keeps
  double one_comb = 0;   // of single combs: what a single sample may be off
};

// The colour of light reflected by a free film of water, against the sum at 1 nm.
Bias film_bias(const Spectrum& lamp, double incidence_deg) {
  const auto combs = wavelength_combs(observer, std::vector<Spectrum>{lamp});
  const optics::Incidence incidence = optics::incidence_from(Degrees(incidence_deg));
  Bias bias;
  for (int thickness_nm = 0; thickness_nm <= 2000; thickness_nm += 20) {
    const auto reflectance = [&](double nm) {
      const optics::Powers p = optics::airy(1, 1.333, 1, thickness_nm, incidence, nm);
      return (p.R_s + p.R_p) / 2;
    };
    Spectrum reflected = lamp;
    for (std::size_t i = 0; i < reflected.size(); ++i) reflected[i] *= reflectance(color::wavelength_nm(i));
    const Xyz exact = exact_xyz(reflected);
    Xyz mean{};
    for (const Comb& comb : combs) {
      const Xyz one = comb_xyz(comb, [&](double nm) { return at_wavelength(lamp, nm) * reflectance(nm); });
      for (std::size_t c = 0; c < 3; ++c) {
        mean[c] += one[c] / comb_count;
        bias.one_comb = std::max(bias.one_comb, std::abs(one[c] - exact[c]));
      }
    }
    for (std::size_t c = 0; c < 3; ++c) bias.all_combs = std::max(bias.all_combs, std::abs(mean[c] - exact[c]));
  }
  return bias;
}

// The renderer's only systematic error in wavelength. Weights that are right for the lamp are slightly wrong for thick
// films, whose fringes (36 nm apart in the blue for 2 um) come near the spacing of the comb.
TEST(Comb, TheMeanOverAllCombsIsTheFilmsColour) {
  for (const color::Illuminant& lamp : color::illuminants())
    for (const double incidence_deg : {0.0, 60.0}) {
      const Bias bias = film_bias(lamp_radiance(lamp), incidence_deg);
      std::printf("[ measured ] %s at %g degrees: XYZ of all combs within %.2g, of one comb %.2g\n",
                  std::string(lamp.name).c_str(), incidence_deg, bias.all_combs, bias.one_comb);
      EXPECT_LT(bias.all_combs, has_lines(lamp) ? 9e-4 : 2.5e-4) << lamp.name;
      EXPECT_LT(bias.one_comb, 0.04) << lamp.name;
    }
}

}  // namespace
}  // namespace shabon::render
