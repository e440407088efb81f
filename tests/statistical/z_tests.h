// Means that must be equal: tests of many differences at once, each against its own error.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shabon::z_tests {

struct Estimate {
  double mean = 0;
  double error = 0;    // standard error of the mean
  double freedom = 1;  // degrees of freedom of the error
};

inline Estimate estimate(const std::vector<double>& values) {
  Estimate result;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) result.mean += v / n;
  double squares = 0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  result.error = std::sqrt(squares / (n * (n - 1)));
  result.freedom = n - 1;
  return result;
}

// The difference as a standard normal number: Welch's t and its degrees of freedom, turned by Wallace's approximation
// (1959) to Student's distribution. `unavoidable` adds to the error: rounding and the like.
inline double z_of_difference(const Estimate& a, const Estimate& b, double unavoidable) {
  const double va = a.error * a.error, vb = b.error * b.error, rest = unavoidable * unavoidable;
  const double sum = va + vb + rest;
  if (!(sum > 0)) return a.mean == b.mean ? 0 : HUGE_VAL;
  const double t = (a.mean - b.mean) / std::sqrt(sum);
  const double freedom = std::min(1e6, sum * sum / std::max(1e-300, va * va / a.freedom + vb * vb / b.freedom));
  const double z = (8 * freedom + 1) / (8 * freedom + 3) * std::sqrt(freedom * std::log1p(t * t / freedom));
  return std::copysign(z, t);
}

// All differences of one test, of which the farthest decides: one in `once_in` tests fails by chance (Sidak).
class Differences {
 public:
  void add(const std::string& name, double z) {
    ++count_;
    squares_ += z * z;
    if (!(std::abs(z) <= std::abs(farthest_))) farthest_ = z, where_ = name;
  }
  double chance_of_farthest() const {
    const double single = std::erfc(std::abs(farthest_) / std::sqrt(2.0));
    return -std::expm1(count_ * std::log1p(-std::min(single, 1 - 1e-15)));
  }
  bool agree(double once_in = 1e4) const { return count_ > 0 && chance_of_farthest() > 1 / once_in; }
  // 1 where nothing but chance makes them.
  double mean_square() const { return squares_ / count_; }
  std::string text() const {
    return std::to_string(count_) + " differences, mean square " + std::to_string(mean_square()) + ", farthest " +
           where_ + " by " + std::to_string(farthest_) + " standard errors (by chance in a share of " +
           std::to_string(chance_of_farthest()) + ")";
  }

 private:
  int count_ = 0;
  double squares_ = 0, farthest_ = 0;
  std::string where_;
};

}  // namespace shabon::z_tests
