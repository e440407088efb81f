#include "shabon/render/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace shabon::render {
namespace {

constexpr std::uint32_t combs = static_cast<std::uint32_t>(comb_count);

struct Offset {
  float x, y;
};

std::vector<Offset> offsets(PixelSeeds seeds, std::uint32_t first, std::uint32_t count) {
  std::vector<Offset> result;
  for (std::uint32_t i = first; i < first + count; ++i)
    result.push_back({pixel_offset_x(i, seeds.x), pixel_offset_y(sobol_second_reversed(i), seeds.y)});
  return result;
}

// Whether each of the cells of a grid of columns x rows holds exactly one offset.
bool one_in_each_cell(const std::vector<Offset>& all, std::uint32_t columns, std::uint32_t rows) {
  std::vector<int> cell(columns * rows);
  for (const Offset& o : all)
    ++cell[static_cast<std::uint32_t>(o.x * static_cast<float>(columns)) * rows +
           static_cast<std::uint32_t>(o.y * static_cast<float>(rows))];
  return std::all_of(cell.begin(), cell.end(), [](int n) { return n == 1; });
}

TEST(Sampling, BitsAreReversed) {
  EXPECT_EQ(reverse_bits(1), 1u << 31);
  EXPECT_EQ(reverse_bits(0x80000001u), 0x80000001u);
  EXPECT_EQ(reverse_bits(0x0000F00Du), 0xB00F0000u);
  for (std::uint32_t k = 0; k < 1000; ++k) EXPECT_EQ(reverse_bits(reverse_bits(k * 2654435761u)), k * 2654435761u);
}

// The first points of Joe and Kuo's sequence in the second and third dimension (new-joe-kuo-6.21201), without Gray
// code.
TEST(Sampling, TheFirstSobolPoints) {
  const std::uint32_t second[] = {0, 8, 12, 4, 10, 2, 6, 14, 15, 7, 3, 11, 5, 13, 9, 1};
  const std::uint32_t third[] = {0, 8, 12, 4, 6, 14, 10, 2, 9, 1, 5, 13, 15, 7, 3, 11};
  for (std::uint32_t i = 0; i < 16; ++i) {
    EXPECT_EQ(reverse_bits(sobol_second_reversed(i)) >> 28, second[i]) << i;
    EXPECT_EQ(static_cast<std::uint32_t>(comb_of_sample(i)) / (combs / 16), third[i]) << i;
  }
}

TEST(Sampling, EveryAlignedBlockSpreadsItsCombs) {
  for (std::uint32_t size = 2; size <= combs; size *= 2)
    for (std::uint32_t block = 0; block < 300; ++block) {
      std::set<std::uint32_t> parts;
      for (std::uint32_t i = block * size; i < (block + 1) * size; ++i) {
        const int comb = comb_of_sample(i);
        ASSERT_GE(comb, 0);
        ASSERT_LT(comb, comb_count);
        parts.insert(static_cast<std::uint32_t>(comb) / (combs / size));
      }
      EXPECT_EQ(parts.size(), size) << "block " << block;
    }
}

TEST(Sampling, CombsOfVeryManySamples) {
  for (const std::uint32_t first : {0u, 1u << 20, 3u << 29, 0u - combs}) {
    std::set<int> met;
    for (std::uint32_t i = 0; i < combs; ++i) met.insert(comb_of_sample(first + i));
    EXPECT_EQ(met.size(), combs) << first;
  }
}

// Owen's scrambling keeps what makes the sequence good: each aligned block of 2^m samples has one sample in every cell
// of every grid of 2^a columns and 2^(m-a) rows.
TEST(Sampling, EveryAlignedBlockIsStratifiedInEveryWay) {
  for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
    const PixelSeeds seeds = pixel_seeds(pixel % 3, 17 * pixel, 400 + pixel);
    for (std::uint32_t m = 1; m <= 8; ++m)
      for (const std::uint32_t block : {0u, 1u, 5u}) {
        const auto all = offsets(seeds, block << m, 1u << m);
        for (std::uint32_t a = 0; a <= m; ++a)
          EXPECT_TRUE(one_in_each_cell(all, 1u << a, 1u << (m - a)))
              << "pixel " << pixel << " block " << block << " of 2^" << m << ", 2^" << a << " columns";
      }
  }
}

TEST(Sampling, OffsetsLieInThePixel) {
  for (std::uint32_t pixel = 0; pixel < 1000; ++pixel)
    for (const Offset& o : offsets(pixel_seeds(9, pixel, 3), 0, 64)) {
      EXPECT_GE(o.x, 0);
      EXPECT_LT(o.x, 1);
      EXPECT_GE(o.y, 0);
      EXPECT_LT(o.y, 1);
    }
}

// Nested scrambling: the leading digits of the result depend on the leading digits of the number alone.
TEST(Sampling, ScramblingIsNested) {
  for (std::uint32_t k = 1; k < 200; ++k) {
    const std::uint32_t x = k * 2654435761u, seed = k * 40503u;
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
      const std::uint32_t below = (1u << bit) - 1;
      EXPECT_EQ((scrambled_reversed(x, seed) ^ scrambled_reversed(x ^ (1u << bit), seed)) & below, 0u);
      EXPECT_NE((scrambled_reversed(x, seed) ^ scrambled_reversed(x ^ (1u << bit), seed)) >> bit & 1, 0u);
    }
  }
}

TEST(Sampling, EveryPixelAndSeedHasItsOwnScramble) {
  std::set<std::uint32_t> xs, ys;
  std::uint32_t count = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (std::uint32_t y = 0; y < 60; ++y)
      for (std::uint32_t x = 0; x < 60; ++x, ++count) {
        const PixelSeeds seeds = pixel_seeds(seed, x, y);
        xs.insert(seeds.x);
        ys.insert(seeds.y);
        EXPECT_NE(seeds.x, seeds.y);
      }
  EXPECT_GE(xs.size() + 2, count);  // 32-bit numbers: a single chance repeat would be no fault
  EXPECT_GE(ys.size() + 2, count);
}

// Over the pixels, the place of one sample is uniform in x and y, and those of neighbours and of x and y are unrelated.
TEST(Sampling, PlacesAreUniformOverPixels) {
  constexpr std::uint32_t width = 200, count = width * width;
  for (const std::uint32_t index : {0u, 1u, 7u}) {
    double mean_x = 0, mean_y = 0, square_x = 0, x_y = 0, x_next = 0, previous = 0;
    for (std::uint32_t p = 0; p < count; ++p) {
      const Offset o = offsets(pixel_seeds(1, p % width, p / width), index, 1)[0];
      const double x = o.x - 0.5, y = o.y - 0.5;
      mean_x += x, mean_y += y, square_x += x * x, x_y += x * y, x_next += x * previous;
      previous = x;
    }
    const double sigma = std::sqrt(count / 12.0);  // of a sum of `count` uniform numbers
    EXPECT_LT(std::abs(mean_x), 4 * sigma);
    EXPECT_LT(std::abs(mean_y), 4 * sigma);
    EXPECT_NEAR(square_x / count, 1.0 / 12, 4 / std::sqrt(180.0 * count));
    EXPECT_LT(std::abs(x_y), 4 * std::sqrt(count) / 12);
    EXPECT_LT(std::abs(x_next), 4 * std::sqrt(count) / 12);
  }
}

}  // namespace
}  // namespace shabon::render
