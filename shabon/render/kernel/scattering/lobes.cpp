#include <bit>
#include <numbers>
#include <optional>

#include "shabon/base/random.h"
#include "shabon/render/kernel/scattering/lobe.h"
#include "shabon/render/microfacet.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

constexpr double pi = std::numbers::pi;

math::Vec3d mirrored(const math::Vec3d& direction, const math::Vec3d& normal) {
  return math::normalize(direction - normal * (2 * math::dot(direction, normal)));
}

// The refracted direction for an index ratio near over far; false beyond the critical angle. `normal` faces the ray.
bool refracted(const math::Vec3d& direction, const math::Vec3d& normal, double ratio, math::Vec3d& result) {
  const double cos_o = -math::dot(direction, normal), sin2 = ratio * ratio * std::max(0.0, 1 - cos_o * cos_o);
  if (sin2 >= 1) return false;
  result = math::normalize(direction * ratio + normal * (ratio * cos_o - std::sqrt(1 - sin2)));
  return true;
}

double near_over_far(const Vertex& vertex, const Lobe& lobe) {
  return lobe.coating.index_ratio(vertex.comb, vertex.hero);
}

// The facet's normal, on the ray's side, that mirrors the ray into `direction`, or refracts it there.
math::Vec3d mirroring_facet(const math::Vec3d& o, const math::Vec3d& i) { return math::normalize(o + i); }

math::Vec3d refracting_facet(const math::Vec3d& o, const math::Vec3d& i, double near_over_far) {
  const math::Vec3d h = o * near_over_far + i;  // in units of the far index
  return math::normalize(h.z > 0 ? h : -h);
}

double refraction_jacobian(double o_h, double i_h, double near_over_far) {
  const double sum = near_over_far * o_h + i_h;
  return std::abs(i_h) / (sum * sum);
}

double mirror_density(const math::Vec3d& o, const math::Vec3d& i, double alpha) {
  if (i.z <= 0) return 0;
  const math::Vec3d h = mirroring_facet(o, i);
  const double o_h = math::dot(o, h);
  return o_h > 0 ? ggx_visible_density(o, h, alpha) / (4 * o_h) : 0;
}

double cosine_density(double cos_i) { return cos_i > 0 ? cos_i / pi : 0; }

bool goes_behind(const Lobe& lobe) { return lobe.kind == LobeKind::rough_refracted; }

// How much of the sampling goes to the part that makes up for the light lost between facets.
double share_of_lost(const Lobe& lobe) { return std::min(0.9f, lobe.lost); }

// The cosines of that part: as the loss asks for where a table tells it, else as a diffuse field has them.
double lost_density(const Lobe& lobe, double cos_i) {
  const CoatingHere& coating = lobe.coating;
  return coating.table->opaque ? cosine_density(cos_i)
                               : coating.rest_table(goes_behind(lobe)).density(cos_i, lobe.alpha, coating.thickness_nm);
}

math::Vec3d lost_direction(const LocalFrame& frame, const Lobe& lobe, double u1, double u2) {
  const CoatingHere& coating = lobe.coating;
  const double cos = coating.table->opaque
                         ? std::sqrt(1 - u1)
                         : coating.rest_table(goes_behind(lobe)).sample_cosine(u1, lobe.alpha, coating.thickness_nm);
  const double z = std::clamp(cos, 1e-6, 1.0), across = std::sqrt(1 - z * z), phi = 2 * pi * u2;
  return frame.world({across * std::cos(phi), across * std::sin(phi), goes_behind(lobe) ? -z : z});
}

// How much more often than others a facet is chosen, in units of the mean.
double facet_choice(const Lobe& lobe, double cos_o, double o_h) {
  if (lobe.coating.table->opaque || lobe.coating.rest_table(false).empty()) return 1;
  const RestTable& rest = lobe.coating.rest_table(false);
  const double nm = lobe.coating.thickness_nm;
  return rest.choice(goes_behind(lobe), o_h, lobe.alpha, nm) /
         rest.mean_choice(goes_behind(lobe), cos_o, lobe.alpha, nm);
}

// Facets are offered as often as they are seen, and taken by choice; u3 is one from the share of lost light to 1.
std::optional<math::Vec3d> sample_facet(const Lobe& lobe, const math::Vec3d& o, double u1, double u2, double u3) {
  const math::Vec3d first = ggx_sample_visible(o, lobe.alpha, u1, u2);
  if (lobe.coating.table->opaque || lobe.coating.rest_table(false).empty()) return first;
  const RestTable& rest = lobe.coating.rest_table(false);
  const auto taken = [&](const math::Vec3d& h, double u) {
    return u < rest.choice(goes_behind(lobe), math::dot(o, h), lobe.alpha, lobe.coating.thickness_nm);
  };
  const double lost = share_of_lost(lobe);
  if (taken(first, (u3 - lost) / (1 - lost))) return first;
  Pcg32 random(std::bit_cast<std::uint64_t>(u1) ^ std::rotl(std::bit_cast<std::uint64_t>(u2), 21) ^
               std::rotl(std::bit_cast<std::uint64_t>(u3), 42));
  constexpr int most_offers = 200;  // one in ten is taken at least
  for (int k = 0; k < most_offers; ++k) {
    const double v1 = random.uniform(), v2 = random.uniform();
    const math::Vec3d h = ggx_sample_visible(o, lobe.alpha, v1, v2);
    if (taken(h, random.uniform())) return h;
  }
  return {};
}

math::Vec3d sample_cosine(const LocalFrame& frame, double u1, double u2) {
  const double r = std::sqrt(u1), phi = 2 * pi * u2;
  return frame.world({r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1e-12, 1 - u1))});
}

math::Vec3d clear_of_horizon(math::Vec3d o) {
  constexpr double least = 1e-4;
  if (o.z >= least) return o;
  o.z = least;
  return math::normalize(o);
}

}  // namespace

optics::FilmMueller<lane_count> CoatingHere::at(std::size_t comb, double cos) const {
  return optics::stack_mueller<lane_count>(from_back ? table->back : table->front, comb * lane_count,
                                           table->ray(from_back, cos, thickness_nm));
}

Block CoatingHere::entering(std::size_t comb, double cos, float alpha) const {
  const Block m = at(comb, cos).transmitted;
  if (alpha < least_alpha) return m;
  return scaled(m, rest(comb, cos, alpha) / max(m.a, Lanes(1e-20f)));
}

Lanes CoatingHere::rest(std::size_t comb, double cos, float alpha, bool behind) const {
  return rest_table(behind).at(comb, cos, alpha, thickness_nm);
}

Lanes CoatingHere::mean_rest(std::size_t comb, float alpha, bool behind) const {
  return rest_table(behind).mean(comb, alpha, thickness_nm);
}

double CoatingHere::index_ratio(std::size_t comb, int lane) const {
  const double front_over_back = table->index_ratio[comb][lane];
  return from_back ? 1 / front_over_back : front_over_back;
}

bool smooth_direction(const Vertex& vertex, const Lobe& lobe, math::Vec3d& direction) {
  switch (lobe.kind) {
    case LobeKind::mirror:
      direction = mirrored(vertex.direction, vertex.normal);
      return true;
    case LobeKind::refracted:
      return refracted(vertex.direction, vertex.normal, near_over_far(vertex, lobe), direction);
    default:
      direction = vertex.direction;
      return true;
  }
}

bool sample(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, double u1, double u2, double u3,
            math::Vec3d& direction) {
  if (lobe.kind == LobeKind::diffuse || lobe.kind == LobeKind::embedded) {
    direction = sample_cosine(frame, u1, u2);
    return true;
  }
  const math::Vec3d o = clear_of_horizon(frame.local(-vertex.direction));
  if (u3 < share_of_lost(lobe)) {
    direction = lost_direction(frame, lobe, u1, u2);
    return true;
  }
  const auto facet = sample_facet(lobe, o, u1, u2, u3);
  if (!facet) return false;
  const math::Vec3d h = *facet;
  math::Vec3d i;
  if (lobe.kind == LobeKind::rough_mirror) {
    i = h * (2 * math::dot(o, h)) - o;
    if (i.z <= 0) return false;
  } else {
    if (!refracted(-o, h, near_over_far(vertex, lobe), i) || i.z >= 0) return false;
  }
  direction = math::normalize(frame.world(i));
  return true;
}

namespace {

double refraction_density(const Vertex& vertex, const Lobe& lobe, const math::Vec3d& o, const math::Vec3d& i) {
  if (i.z >= 0) return 0;
  const double ratio = near_over_far(vertex, lobe);
  const math::Vec3d h = refracting_facet(o, i, ratio);
  const double o_h = math::dot(o, h), i_h = math::dot(i, h);
  if (o_h <= 0 || i_h >= 0) return 0;
  return ggx_visible_density(o, h, lobe.alpha) * refraction_jacobian(o_h, i_h, ratio);
}

}  // namespace

double density(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const math::Vec3d& direction) {
  const math::Vec3d i = frame.local(direction);
  if (lobe.kind == LobeKind::diffuse || lobe.kind == LobeKind::embedded) return cosine_density(i.z);
  const math::Vec3d o = clear_of_horizon(frame.local(-vertex.direction));
  const bool behind = goes_behind(lobe);
  double once = behind ? refraction_density(vertex, lobe, o, i) : mirror_density(o, i, lobe.alpha);
  if (once > 0) {
    const math::Vec3d h = behind ? refracting_facet(o, i, near_over_far(vertex, lobe)) : mirroring_facet(o, i);
    once *= facet_choice(lobe, o.z, math::dot(o, h));
  }
  const double lost = share_of_lost(lobe);
  return lost > 0 ? (1 - lost) * once + lost * lost_density(lobe, behind ? -i.z : i.z) : once;
}

namespace {

// A facet with the film on it: exact for the light that it mirrors or refracts once.
FramedRow from_facet(const Vertex& vertex, const LocalFrame& frame, const FramedRow& arriving, const math::Vec3d& h,
                     const Block& block, double factor) {
  const math::Vec3d normal = frame.world(h);
  const math::Vec3d s = s_axis(vertex.direction, normal);
  const Row row = optics::through(arriving.in_frame(vertex.direction, s), block);
  return {scaled(row, Lanes(static_cast<float>(factor))), s, true};
}

FramedRow from_rough_mirror(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const FramedRow& arriving,
                            const math::Vec3d& o, const math::Vec3d& i) {
  FramedRow result{unpolarized(Lanes(0.0f)), {}, false};
  if (i.z <= 0) return result;
  const math::Vec3d h = mirroring_facet(o, i);
  const double o_h = math::dot(o, h);
  if (o_h > 0) {
    const double factor = mirror_density(o, i, lobe.alpha) * ggx_also_visible(o.z, i.z, lobe.alpha);
    result = from_facet(vertex, frame, arriving, h, lobe.coating.at(vertex.comb, o_h).reflected, factor);
  }
  return result;
}

FramedRow from_rough_refraction(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe,
                                const FramedRow& arriving, const math::Vec3d& o, const math::Vec3d& i) {
  const double once = refraction_density(vertex, lobe, o, i);
  if (once <= 0) return {unpolarized(Lanes(0.0f)), {}, false};
  const math::Vec3d h = refracting_facet(o, i, near_over_far(vertex, lobe));
  const Block block = lobe.coating.at(vertex.comb, math::dot(o, h)).transmitted;
  return from_facet(vertex, frame, arriving, h, block, once * ggx_also_visible_behind(o.z, -i.z, lobe.alpha));
}

// What single scattering loses comes out as the way back asks for, unpolarised, (56) and (62).
void add_lost(const Vertex& vertex, const Lobe& lobe, const FramedRow& arriving, double cos_i, FramedRow& result) {
  if (lobe.lost <= 0 || cos_i <= 0) return;
  const Lanes lost_i = lobe.coating.table->opaque
                           ? Lanes(static_cast<float>(1 - single_scattering(cos_i, lobe.alpha)))
                           : lobe.coating.rest(vertex.comb, cos_i, lobe.alpha, goes_behind(lobe));
  result.row.q0 += arriving.row.q0 * lobe.albedo * lost_i * Lanes(static_cast<float>(cosine_density(cos_i)));
}

// Into the embedded base and out again: the boundary polarises both ways, the base does not, (57).
FramedRow from_embedded(const Vertex& vertex, const Lobe& lobe, const FramedRow& arriving, const math::Vec3d& direction,
                        double cos_i) {
  if (cos_i <= 0) return {unpolarized(Lanes(0.0f)), {}, false};
  const math::Vec3d s_o = s_axis(vertex.direction, vertex.normal);
  const Row in = arriving.in_frame(vertex.direction, s_o);
  const Lanes entered = lobe.block.a * in.q0 + lobe.block.b * in.q1;
  const Lanes base = entered * lobe.albedo * Lanes(static_cast<float>(cosine_density(cos_i)));
  const Block out = lobe.coating.entering(vertex.comb, cos_i, lobe.alpha);
  return {{base * out.a, base * out.b, Lanes(0.0f), Lanes(0.0f)}, s_axis(direction, vertex.normal), true};
}

}  // namespace

FramedRow scattered(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const FramedRow& arriving,
                    const math::Vec3d& direction) {
  const math::Vec3d i = frame.local(direction);
  if (lobe.kind == LobeKind::diffuse)
    return {unpolarized(arriving.row.q0 * lobe.albedo * Lanes(static_cast<float>(cosine_density(i.z)))), {}, false};
  if (lobe.kind == LobeKind::embedded) return from_embedded(vertex, lobe, arriving, direction, i.z);
  const math::Vec3d o = clear_of_horizon(frame.local(-vertex.direction));
  const bool behind = goes_behind(lobe);
  FramedRow result = behind ? from_rough_refraction(vertex, frame, lobe, arriving, o, i)
                            : from_rough_mirror(vertex, frame, lobe, arriving, o, i);
  add_lost(vertex, lobe, arriving, behind ? -i.z : i.z, result);
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
