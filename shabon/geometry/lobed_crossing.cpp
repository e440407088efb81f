// Where rays meet a lobed sphere.
#include "shabon/geometry/lobes.h"

namespace shabon::geometry {

namespace {

using math::Vec3d;

// |p| - radius along a ray with its derivatives by the distance: below 0 inside.
struct Height {
  double value, slope, bend;
};

class Ray {
 public:
  // `across` is the ray's point nearest to the centre, from which distances are counted; the direction has unit length.
  Ray(const LobedSphere& lobed, Vec3d across, Vec3d direction)
      : lobed_(lobed), across_(across), direction_(direction), bounds_(bounds_of(lobed)) {
    const double low = bounds_.low;
    most_bend_ = 1 / low + (bounds_.slope + bounds_.bend) / (low * low);
    squared_ = dot(across, across);
  }

  bool may_meet() const { return squared_ < bounds_.high * bounds_.high; }
  double end() const { return std::sqrt(bounds_.high * bounds_.high - squared_); }
  // Within this distance of its middle the ray is inside.
  double inner() const { return std::sqrt(std::max(0.0, bounds_.low * bounds_.low - squared_)); }

  Height at(double s) const {
    const Vec3d p = across_ + direction_ * s;
    const double q = math::length(p);
    const Vec3d n = p * (1 / q);
    const double c = dot(n, direction_);
    const Vec3d turn = (direction_ - n * c) * (1 / q);                           // dn/ds
    const Vec3d bend = turn * (-2 * c / q) - n * ((1 - c) * (1 + c) / (q * q));  // its derivative
    Height height{q - lobed_.mean, c, (1 - c) * (1 + c) / q};
    for (const Lobe& lobe : lobed_.lobes) {
      const double x = dot(n, lobe.axis), dx = dot(turn, lobe.axis);
      const Legendre p_l = legendre(lobe.degree, x);
      height.value -= lobe.amplitude * p_l.value;
      height.slope -= lobe.amplitude * p_l.slope * dx;
      height.bend -= lobe.amplitude * (p_l.bend * dx * dx + p_l.slope * dot(bend, lobe.axis));
    }
    return height;
  }

  // The first crossing in from < s < to, which lies in the shell between the bounds. The ray starts on `side` of the
  // surface: -1 inside, 1 outside.
  std::optional<double> first(double from, double to, double side) const {
    double s = from;
    for (int step = 0; step < most_steps; ++step) {
      const Height here = at(s);
      const double height = side * here.value, rise = side * here.slope;
      if (!(height > 0)) return s;
      if (rise < -steep && height <= noise()) return s - height / rise;
      const double root = std::sqrt(rise * rise + 2 * most_bend_ * height);
      s += rise < 0 ? 2 * height / (root - rise) : (rise + root) / most_bend_;
      if (!(s < to)) return {};
    }
    return side < 0 && at(to).value > 0 ? std::optional(bisected(s, to)) : std::nullopt;
  }

  // The crossing after one at `from`.
  std::optional<double> after(double from, double to) const {
    const Height here = at(from);
    // The root of the parabola there: where it is so near, the height itself is lost in rounding.
    const double chord = -2 * here.slope / here.bend;
    if (chord > 0 && chord <= near()) return from + chord;
    const double side = here.slope + here.bend * near() / 2 > 0 ? 1 : -1;
    return from + near() < to ? first(from + near(), to, side) : std::nullopt;
  }

 private:
  static constexpr int most_steps = 400;
  static constexpr double steep = 1e-6;
  double noise() const { return 4e-16 * bounds_.high; }
  double near() const { return 1e-6 * bounds_.low; }

  // A ray that is inside leaves, however near it runs along the surface.
  double bisected(double inside, double outside) const {
    for (int k = 0; k < 60; ++k) {
      const double middle = (inside + outside) / 2;
      (at(middle).value < 0 ? inside : outside) = middle;
    }
    return outside;
  }

  const LobedSphere& lobed_;
  Vec3d across_, direction_;
  LobeBounds bounds_;
  double most_bend_, squared_;
};

struct Piece {
  double from, to;
};

std::optional<double> crossing(const Ray& ray, double start, bool starts_on_it) {
  const double end = ray.end(), inner = ray.inner();
  const Piece outward{inner, end}, inward{-end, -inner}, all{-end, end};
  for (const Piece& piece : {inner > 0 ? inward : all, outward}) {
    const double from = std::max(piece.from, start);
    if (!(from < piece.to)) continue;
    const double height = ray.at(from).value;
    const bool leaves = from == start && (starts_on_it || height == 0);
    if (const auto found = leaves ? ray.after(from, piece.to) : ray.first(from, piece.to, height < 0 ? -1 : 1))
      return found;
    if (!(inner > 0)) break;
  }
  return {};
}

}  // namespace

std::optional<double> next_crossing(const LobedSphere& lobed, Vec3d origin, Vec3d direction, bool starts_on_it) {
  const double unit = 1 / math::length(direction);
  const Vec3d d = direction * unit;
  const double start = dot(origin, d);
  const Ray ray(lobed, origin - d * start, d);
  if (!ray.may_meet()) return {};
  const auto found = crossing(ray, start, starts_on_it);
  if (!found || !(*found > start)) return {};
  return (*found - start) * unit;
}

}  // namespace shabon::geometry
