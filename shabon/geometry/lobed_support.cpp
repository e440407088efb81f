// How far a lobed sphere reaches in a direction.
#include <array>

#include "shabon/geometry/lobes.h"
#include "shabon/math/normal_to.h"

namespace shabon::geometry {

namespace {

using math::Vec3d;

// radius(n) (n . g) over the sphere, with its first two derivatives in two directions across n.
struct Extent {
  double value = 0;
  std::array<Vec3d, 2> across;
  std::array<double, 2> slope{};
  std::array<double, 3> bend{};  // 11, 12, 22
};

Extent extent_at(const LobedSphere& lobed, Vec3d n, Vec3d g) {
  const double c = dot(n, g);
  Extent at;
  at.across[0] = math::any_normal_to(n), at.across[1] = cross(n, at.across[0]);
  double radius = lobed.mean, round = 0;
  std::array<double, 2> slope{};
  std::array<double, 3> bend{};
  for (const Lobe& lobe : lobed.lobes) {
    const double x = dot(n, lobe.axis), e1 = dot(at.across[0], lobe.axis), e2 = dot(at.across[1], lobe.axis);
    const Legendre p = legendre(lobe.degree, x);
    radius += lobe.amplitude * p.value, round += lobe.amplitude * p.slope * x;
    slope[0] += lobe.amplitude * p.slope * e1, slope[1] += lobe.amplitude * p.slope * e2;
    bend[0] += lobe.amplitude * p.bend * e1 * e1, bend[1] += lobe.amplitude * p.bend * e1 * e2;
    bend[2] += lobe.amplitude * p.bend * e2 * e2;
  }
  const double g1 = dot(at.across[0], g), g2 = dot(at.across[1], g);
  at.value = radius * c;
  at.slope = {slope[0] * c + radius * g1, slope[1] * c + radius * g2};
  at.bend = {(bend[0] - round) * c + 2 * slope[0] * g1 - radius * c, bend[1] * c + slope[0] * g2 + slope[1] * g1,
             (bend[2] - round) * c + 2 * slope[1] * g2 - radius * c};
  return at;
}

// Looks for the largest value where no bound rules it out.
class Search {
 public:
  Search(const LobedSphere& lobed, Vec3d g) : lobed_(lobed), g_(g) {
    const LobeBounds bounds = bounds_of(lobed);
    most_bend_ = bounds.bend + 2 * bounds.slope + bounds.high;
    int highest = 1;
    for (const Lobe& lobe : lobed.lobes) highest = std::max(highest, lobe.degree);
    finest_ = std::min(0.05, 0.4 / highest);
  }

  double largest() {
    climb(g_);
    for (int face = 0; face < 6; ++face) look(face, 0, 0, 1);
    return best_;
  }

 private:
  // The square about (u, v) of a face of the cube around the sphere, 2 `half` wide.
  void look(int face, double u, double v, double half) {
    const double sign = face < 3 ? 1 : -1;
    const std::array<double, 3> p{sign, u, v};
    const auto at = [&](int k) { return p[static_cast<std::size_t>((k + face) % 3)]; };
    const Vec3d n = math::normalize(Vec3d{at(0), at(1), at(2)});
    const double reach = std::sqrt(2.0) * half;  // in radians: no more than on the cube
    const Extent here = extent_at(lobed_, n, g_);
    const double slope = std::hypot(here.slope[0], here.slope[1]);
    constexpr double enough = 1 + 1e-14;
    if (here.value + slope * reach + most_bend_ * reach * reach / 2 <= best_ * enough) return;
    if (half <= finest_) return climb(n);
    const double quarter = half / 2;
    for (const double du : {-quarter, quarter})
      for (const double dv : {-quarter, quarter}) look(face, u + du, v + dv, quarter);
  }

  // Newton's steps, or where they lead down ones along the slope, which never do.
  void climb(Vec3d n) {
    Extent here = extent_at(lobed_, n, g_);
    for (int step = 0; step < 40; ++step) {
      const auto [a, b, d] = here.bend;
      const double determinant = a * d - b * b;
      const auto moved = [&](double x, double y) {
        return math::normalize(n + here.across[0] * x + here.across[1] * y);
      };
      Vec3d next = moved(here.slope[0] / most_bend_, here.slope[1] / most_bend_);
      if (a < 0 && determinant > 0) {
        const Vec3d newton = moved((b * here.slope[1] - d * here.slope[0]) / determinant,
                                   (b * here.slope[0] - a * here.slope[1]) / determinant);
        if (extent_at(lobed_, newton, g_).value >= here.value) next = newton;
      }
      const Extent there = extent_at(lobed_, next, g_);
      if (!(there.value > here.value)) break;
      n = next, here = there;
    }
    best_ = std::max(best_, here.value);
  }

  const LobedSphere& lobed_;
  Vec3d g_;
  double most_bend_ = 1, finest_ = 0.05, best_ = 0;
};

}  // namespace

double support(const LobedSphere& lobed, Vec3d g) {
  const double size = math::length(g);
  if (!(size > 0)) return 0;
  return size * Search(lobed, g * (1 / size)).largest();
}

}  // namespace shabon::geometry
