#include "shabon/geometry/shapes/torus.h"

#include <array>

namespace shabon::geometry {

namespace {

using math::Vec3d;

// A place where `value` changes its sign between two others, by Newton's method kept between them by halving.
// `at` gives value and slope; `low_is_negative` is the sign at `low`.
template <class At>
double root_between(const At& at, double low, double high, bool low_is_negative) {
  constexpr double rounding = 2e-16;
  double x = (low + high) / 2;
  for (int k = 0; k < 100; ++k) {
    const auto [value, slope] = at(x);
    ((value < 0) == low_is_negative ? low : high) = x;
    const double newton = x - value / slope;
    if (std::abs(newton - x) <= rounding * x) break;
    x = newton > low && newton < high ? newton : (low + high) / 2;
    if (!(x > low && x < high)) break;
  }
  return x;
}

struct Value {
  double value, slope;
};

// Along a ray of a unit direction, the polynomial that is 0 on the torus, below 0 within the tube:
// (|p|^2 + 1 - tube^2)^2 - 4 (x^2 + z^2) = s^4 + c3 s^3 + c2 s^2 + c1 s + c0.
class Ray {
 public:
  Ray(const Torus& torus, Vec3d origin, Vec3d direction) : tube_(torus.tube), o_(origin), d_(direction) {
    const double flat = o_.x * d_.x + o_.z * d_.z, along = dot(o_, d_), k = dot(o_, o_) + 1 - tube_ * tube_;
    c3_ = 4 * along;
    c2_ = 2 * k + 4 * along * along - 4 * (d_.x * d_.x + d_.z * d_.z);
    c1_ = 4 * (flat * (k - 2) + o_.y * d_.y * k);
  }

  // The first sign change in (0, end], from within the tube or from outside of it.
  std::optional<double> first(double end, bool starts_on_it) const {
    double from = 0;
    bool within = starts_on_it ? c1_ < 0 : gap(0).value < 0;
    bool first_piece = starts_on_it;
    for (const double to : turns(end)) {
      if (to <= from) continue;
      // Up to the first turn there is no way back to where it started.
      const bool same = (first_piece && to < end) || (gap(to).value < 0) == within;
      if (!same) return root_between([this](double s) { return gap(s); }, from, to, within);
      from = to, first_piece = false;
    }
    return {};
  }

 private:
  // (distance from the middle line)^2 - tube^2: the polynomial without its factor that is never 0.
  Value gap(double s) const {
    const double x = o_.x + s * d_.x, y = o_.y + s * d_.y, z = o_.z + s * d_.z, r = std::hypot(x, z);
    const double slope_of_r = r > 0 ? (x * d_.x + z * d_.z) / r : 0;
    return {(r - 1) * (r - 1) + y * y - tube_ * tube_, 2 * ((r - 1) * slope_of_r + y * d_.y)};
  }

  Value slope(double s) const {
    return {((4 * s + 3 * c3_) * s + 2 * c2_) * s + c1_, (12 * s + 6 * c3_) * s + 2 * c2_};
  }

  // Where the polynomial turns, in rising order, and the end: between two of them it only rises or only falls.
  std::array<double, 4> turns(double end) const {
    std::array<double, 4> found{end, end, end, end};
    std::size_t count = 0;
    double from = 0;
    bool falls = c1_ < 0;
    for (const double to : bends(end)) {
      if (to <= from) continue;
      if ((slope(to).value < 0) != falls) {
        found[count++] = root_between([this](double s) { return slope(s); }, from, to, falls);
        falls = !falls;
      }
      from = to;
    }
    return found;
  }

  // Where the slope turns, and the end.
  std::array<double, 3> bends(double end) const {
    const double half = -c3_ / 4, square = half * half - c2_ / 6;
    if (!(square > 0)) return {end, end, end};
    const double root = std::sqrt(square);
    return {std::min(half - root, end), std::min(half + root, end), end};
  }

  double tube_;
  Vec3d o_, d_;
  double c3_ = 0, c2_ = 0, c1_ = 0;
};

struct Piece {
  double from, to;
};

// The part of the ray, of a unit direction, that is not too far from the axis and the plane of the ring.
std::optional<Piece> near_part(const Torus& torus, Vec3d origin, Vec3d direction) {
  constexpr double slack = 1 + 1e-9;
  const double reach = (1 + torus.tube) * slack, height = torus.tube * slack;
  const double middle = -dot(origin, direction);
  const Vec3d nearest = origin + direction * middle;
  const double half_squared = reach * reach - dot(nearest, nearest);
  if (!(half_squared > 0)) return {};
  const double half = std::sqrt(half_squared);
  Piece piece{std::max(0.0, middle - half), middle + half};
  if (direction.y != 0) {
    const double a = (-height - origin.y) / direction.y, b = (height - origin.y) / direction.y;
    piece = {std::max(piece.from, std::min(a, b)), std::min(piece.to, std::max(a, b))};
  } else if (std::abs(origin.y) > height) {
    return {};
  }
  if (!(piece.from < piece.to)) return {};
  return piece;
}

}  // namespace

std::optional<double> next_crossing(const Torus& torus, Vec3d origin, Vec3d direction, bool starts_on_it) {
  const double unit = 1 / math::length(direction);
  const Vec3d d = direction * unit;
  const auto piece = near_part(torus, origin, d);
  if (!piece) return {};
  // From where it comes near: the polynomial loses digits with the distance.
  const double start = starts_on_it ? 0 : piece->from;
  const auto found = Ray(torus, origin + d * start, d).first(piece->to - start, starts_on_it);
  if (!found || !(start + *found > 0)) return {};
  return (start + *found) * unit;
}

}  // namespace shabon::geometry
