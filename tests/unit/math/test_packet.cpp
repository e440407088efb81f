// Every operation of packet<T, N> against the same operation on each lane alone, for all sizes: bit by bit.
#include "shabon/math/packet.h"
#include "shabon/math/packet_convert.h"
#include "shabon/math/packet_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shabon/base/random.h"

namespace shabon::math {
namespace {

template <class T, int N>
struct Kind {
  using Number = T;
  static constexpr int size = N;
};

using Kinds = testing::Types<Kind<float, 4>, Kind<float, 8>, Kind<float, 16>, Kind<float, 32>, Kind<double, 4>,
                             Kind<double, 8>, Kind<double, 16>, Kind<double, 32>>;

template <class K>
class Packet : public testing::Test {
 public:
  using Number = typename K::Number;
  static constexpr int size = K::size;
  using Pack = packet<Number, size>;
  using Mask = packet_mask<Number, size>;
  using Lanes = std::array<Number, size>;

  // Numbers of both signs over many powers of two, with repeats, zeros and infinities in between.
  Lanes numbers() {
    Lanes lanes;
    for (Number& lane : lanes) {
      const auto kind = random_() % 16;
      if (kind == 0)
        lane = 0;
      else if (kind == 1)
        lane = std::numeric_limits<Number>::infinity();
      else if (kind < 6)
        lane = static_cast<Number>(static_cast<int>(random_() % 7) - 3);
      else
        lane = std::ldexp(static_cast<Number>(random_.uniform(-1, 1)), static_cast<int>(random_() % 20) - 10);
    }
    return lanes;
  }
  Lanes numbers_within(double limit) {
    Lanes lanes;
    for (Number& lane : lanes) lane = static_cast<Number>(random_.uniform(-limit, limit));
    return lanes;
  }

  static Pack packed(const Lanes& lanes) { return Pack::load(lanes.data()); }

  // Equal numbers, zeros of either sign alike, or both not a number.
  template <class Function>
  static void expect_lanes(const Pack& result, const Function& expected) {
    Lanes stored;
    result.store(stored.data());
    for (int i = 0; i < size; ++i) {
      const Number e = expected(static_cast<std::size_t>(i));
      if (std::isnan(e)) {
        EXPECT_TRUE(std::isnan(result[i])) << "lane " << i;
      } else {
        EXPECT_EQ(result[i], e) << "lane " << i;
        EXPECT_EQ(stored[static_cast<std::size_t>(i)], e) << "lane " << i;
      }
    }
  }
  template <class Function>
  static void expect_mask(const Mask& mask, const Function& expected) {
    std::uint32_t wanted = 0;
    for (int i = 0; i < size; ++i) wanted |= expected(static_cast<std::size_t>(i)) ? 1u << i : 0u;
    EXPECT_EQ(bits(mask), wanted);
    EXPECT_EQ(any(mask), wanted != 0);
    expect_lanes(select(mask, Pack(Number(1)), Pack(Number(2))),
                 [&](std::size_t i) { return wanted >> i & 1 ? Number(1) : Number(2); });
  }

 private:
  Pcg32 random_{11};
};

TYPED_TEST_SUITE(Packet, Kinds);

constexpr int repeats = 200;

TYPED_TEST(Packet, ARegisterHoldsAsManyLanesAsItsBytes) {
  using T = typename TestFixture::Number;
  EXPECT_EQ(TestFixture::Pack::size, TestFixture::size);
  EXPECT_EQ(sizeof(typename TestFixture::Pack), sizeof(T) * TestFixture::size);
  EXPECT_EQ(is_leaf<typename TestFixture::Pack>, sizeof(T) * TestFixture::size <= register_bytes);
}

TYPED_TEST(Packet, LoadsStoresAndFills) {
  const auto a = this->numbers();
  this->expect_lanes(this->packed(a), [&](std::size_t i) { return a[i]; });
  this->expect_lanes(typename TestFixture::Pack(a[0]), [&](std::size_t) { return a[0]; });
}

TYPED_TEST(Packet, LoadsFromAnyLane) {
  using T = typename TestFixture::Number;
  const auto a = this->numbers();
  std::array<T, TestFixture::size + 1> shifted{};
  std::copy(a.begin(), a.end(), shifted.begin() + 1);
  this->expect_lanes(TestFixture::Pack::load(shifted.data() + 1), [&](std::size_t i) { return a[i]; });
}

TYPED_TEST(Packet, GathersFromAnyPlaces) {
  const auto numbers = this->numbers();
  int places[TestFixture::size];
  for (int lane = 0; lane < TestFixture::size; ++lane) places[lane] = (lane * 5 + 3) % TestFixture::size;
  const auto pack = gathered<typename TestFixture::Pack>(numbers.data(), places);
  for (int lane = 0; lane < TestFixture::size; ++lane) EXPECT_EQ(pack[lane], numbers[std::size_t(places[lane])]);
}

TYPED_TEST(Packet, CalculatesLaneByLane) {
  using T = typename TestFixture::Number;
  using P = typename TestFixture::Pack;
  for (int k = 0; k < repeats; ++k) {
    const auto a = this->numbers(), b = this->numbers();
    const P p = this->packed(a), q = this->packed(b);
    const T s = b[0];
    this->expect_lanes(p + q, [&](std::size_t i) { return a[i] + b[i]; });
    this->expect_lanes(p - q, [&](std::size_t i) { return a[i] - b[i]; });
    this->expect_lanes(p * q, [&](std::size_t i) { return a[i] * b[i]; });
    this->expect_lanes(p / q, [&](std::size_t i) { return a[i] / b[i]; });
    this->expect_lanes(p + s, [&](std::size_t i) { return a[i] + s; });
    this->expect_lanes(p - s, [&](std::size_t i) { return a[i] - s; });
    this->expect_lanes(p * s, [&](std::size_t i) { return a[i] * s; });
    this->expect_lanes(p / s, [&](std::size_t i) { return a[i] / s; });
    this->expect_lanes(s + p, [&](std::size_t i) { return s + a[i]; });
    this->expect_lanes(s - p, [&](std::size_t i) { return s - a[i]; });
    this->expect_lanes(s * p, [&](std::size_t i) { return s * a[i]; });
    this->expect_lanes(s / p, [&](std::size_t i) { return s / a[i]; });
    this->expect_lanes(-p, [&](std::size_t i) { return -a[i]; });
    P sum = p, product = p;
    this->expect_lanes(sum += q, [&](std::size_t i) { return a[i] + b[i]; });
    this->expect_lanes(product *= q, [&](std::size_t i) { return a[i] * b[i]; });
    this->expect_lanes(sum, [&](std::size_t i) { return a[i] + b[i]; });
    this->expect_lanes(product, [&](std::size_t i) { return a[i] * b[i]; });
  }
}

TYPED_TEST(Packet, ComparesLaneByLane) {
  for (int k = 0; k < repeats; ++k) {
    auto a = this->numbers(), b = this->numbers();
    a[0] = b[0];
    b[1] = std::numeric_limits<typename TestFixture::Number>::quiet_NaN();  // every comparison with it is false
    const auto p = this->packed(a), q = this->packed(b);
    this->expect_mask(p < q, [&](std::size_t i) { return a[i] < b[i]; });
    this->expect_mask(p <= q, [&](std::size_t i) { return a[i] <= b[i]; });
    this->expect_mask(p > q, [&](std::size_t i) { return a[i] > b[i]; });
    this->expect_mask(p >= q, [&](std::size_t i) { return a[i] >= b[i]; });
    this->expect_mask(p == q, [&](std::size_t i) { return a[i] == b[i]; });
    this->expect_mask((p < q) & (p > -q), [&](std::size_t i) { return a[i] < b[i] && a[i] > -b[i]; });
    this->expect_mask((p < q) | (p == q), [&](std::size_t i) { return a[i] < b[i] || a[i] == b[i]; });
  }
}

TYPED_TEST(Packet, EveryLaneHasItsOwnBit) {
  using T = typename TestFixture::Number;
  using P = typename TestFixture::Pack;
  for (int lane = 0; lane < TestFixture::size; ++lane) {
    typename TestFixture::Lanes a{};
    a[static_cast<std::size_t>(lane)] = 1;
    EXPECT_EQ(bits(this->packed(a) > P(T(0))), 1u << lane);
  }
  EXPECT_FALSE(any(P(T(0)) > P(T(0))));
  EXPECT_EQ(bits(P(T(1)) > P(T(0))), TestFixture::size == 32 ? ~0u : (1u << TestFixture::size) - 1);
}

TYPED_TEST(Packet, SelectsTheSmallerAndTheLarger) {
  for (int k = 0; k < repeats; ++k) {
    const auto a = this->numbers(), b = this->numbers();
    const auto p = this->packed(a), q = this->packed(b);
    this->expect_lanes(select(p < q, p + q, p - q),
                       [&](std::size_t i) { return a[i] < b[i] ? a[i] + b[i] : a[i] - b[i]; });
    this->expect_lanes(min(p, q), [&](std::size_t i) { return std::min(a[i], b[i]); });
    this->expect_lanes(max(p, q), [&](std::size_t i) { return std::max(a[i], b[i]); });
    this->expect_lanes(abs(p), [&](std::size_t i) { return std::abs(a[i]); });
    this->expect_lanes(sqrt(abs(p)), [&](std::size_t i) { return std::sqrt(std::abs(a[i])); });
  }
}

TYPED_TEST(Packet, AbsoluteValuesHaveNoSign) {
  using T = typename TestFixture::Number;
  using P = typename TestFixture::Pack;
  for (const T zero : {T(0), -T(0)})
    for (int i = 0; i < TestFixture::size; ++i) EXPECT_FALSE(std::signbit(abs(P(zero))[i])) << zero;
}

TYPED_TEST(Packet, RootsOfNegativeNumbersAreNotNumbers) {
  using T = typename TestFixture::Number;
  const auto root = sqrt(typename TestFixture::Pack(T(-1)));
  for (int i = 0; i < TestFixture::size; ++i) EXPECT_TRUE(std::isnan(root[i]));
}

TYPED_TEST(Packet, RoundsHalvesToEven) {
  using T = typename TestFixture::Number;
  const double limit = sizeof(T) == 4 ? 0x1p21 : 0x1p50;
  for (const double within : {2.0, 100.0, 1e5, limit})
    for (int k = 0; k < repeats; ++k) {
      auto a = this->numbers_within(within);
      a[0] = std::floor(a[0]) + T(0.5);
      a[1] = std::floor(a[1]);
      const auto p = this->packed(a);
      this->expect_lanes(round(p), [&](std::size_t i) { return std::nearbyint(a[i]); });
      this->expect_lanes(floor(p), [&](std::size_t i) { return std::floor(a[i]); });
    }
}

TYPED_TEST(Packet, AddsHalvesFirst) {
  using T = typename TestFixture::Number;
  for (int k = 0; k < repeats; ++k) {
    const auto a = this->numbers_within(1);
    auto folded = a;
    T largest_lane = a[0];
    for (std::size_t half = TestFixture::size / 2; half > 0; half /= 2)
      for (std::size_t i = 0; i < half; ++i) folded[i] += folded[i + half];
    for (const T lane : a) largest_lane = std::max(largest_lane, lane);
    EXPECT_EQ(sum(this->packed(a)), folded[0]);
    EXPECT_EQ(largest(this->packed(a)), largest_lane);
  }
}

TYPED_TEST(Packet, FindsTheLargestInEveryLane) {
  for (int lane = 0; lane < TestFixture::size; ++lane) {
    auto a = this->numbers_within(1);
    a[static_cast<std::size_t>(lane)] = 2;
    EXPECT_EQ(largest(this->packed(a)), 2);
  }
}

TYPED_TEST(Packet, ConvertsLaneByLane) {
  using T = typename TestFixture::Number;
  for (int k = 0; k < repeats; ++k) {
    const auto a = this->numbers();
    const auto single = convert<float>(this->packed(a));
    const auto twice = convert<double>(this->packed(a));
    for (int i = 0; i < TestFixture::size; ++i) {
      EXPECT_EQ(single[i], static_cast<float>(a[static_cast<std::size_t>(i)])) << "lane " << i;
      EXPECT_EQ(twice[i], static_cast<double>(a[static_cast<std::size_t>(i)])) << "lane " << i;
    }
    if constexpr (std::is_same_v<T, double>) {
      for (int i = 0; i < TestFixture::size; ++i)
        EXPECT_EQ(narrow(this->packed(a))[i], narrow(a[static_cast<std::size_t>(i)]));
    }
  }
}

}  // namespace
}  // namespace shabon::math
