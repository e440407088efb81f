#include <numbers>

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

// How much of the sampling goes to the part that makes up for the light lost between facets.
double share_of_lost(const Lobe& lobe) { return std::min(0.9f, lobe.lost); }

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
  const optics::StackTable& stack = from_back && !table->opaque ? table->back : table->front;
  optics::StackRay ray{.cos_i = cos};
  if (thickness_nm >= 0) {
    const std::size_t layer = table->coating->varied->layer;
    ray.layer = &stack == &table->back ? stack.layers.size() - 1 - layer : layer;
    ray.thickness_nm = thickness_nm;
  }
  return optics::stack_mueller<lane_count>(stack, comb * lane_count, ray);
}

// Gauss and Legendre's rule in the cosine, with the weight 2 cos.
CoatingHere::Means CoatingHere::diffuse_means(std::size_t comb) const {
  constexpr double nodes[] = {0.03376524289842397, 0.16939530676686776, 0.38069040695840156,
                              0.6193095930415985,  0.8306046932331322,  0.966234757101576};
  constexpr double weights[] = {0.08566224618958525, 0.1803807865240693, 0.23395696728634546,
                                0.23395696728634546, 0.1803807865240693, 0.08566224618958525};
  Means means{Lanes(0.0f), Lanes(0.0f)};
  for (std::size_t k = 0; k < std::size(nodes); ++k) {
    const auto m = at(comb, nodes[k]);
    const Lanes weight(static_cast<float>(2 * nodes[k] * weights[k]));
    means.reflected += m.reflected.a * weight, means.transmitted += m.transmitted.a * weight;
  }
  return means;
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
  if (lobe.kind == LobeKind::rough_mirror && u3 < share_of_lost(lobe)) {
    direction = sample_cosine(frame, u1, u2);
    return true;
  }
  const math::Vec3d h = ggx_sample_visible(o, lobe.alpha, u1, u2);
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

double density(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const math::Vec3d& direction) {
  const math::Vec3d i = frame.local(direction);
  if (lobe.kind == LobeKind::diffuse || lobe.kind == LobeKind::embedded) return cosine_density(i.z);
  const math::Vec3d o = clear_of_horizon(frame.local(-vertex.direction));
  if (lobe.kind == LobeKind::rough_mirror) {
    const double lost = share_of_lost(lobe);
    return (1 - lost) * mirror_density(o, i, lobe.alpha) + lost * cosine_density(i.z);
  }
  if (i.z >= 0) return 0;
  const double ratio = near_over_far(vertex, lobe);
  const math::Vec3d h = refracting_facet(o, i, ratio);
  const double o_h = math::dot(o, h), i_h = math::dot(i, h);
  if (o_h <= 0 || i_h >= 0) return 0;
  return ggx_visible_density(o, h, lobe.alpha) * refraction_jacobian(o_h, i_h, ratio);
}

namespace {

// A facet with the film on it: exact for the light that it mirrors or refracts once.
FramedRow from_facet(const Vertex& vertex, const LocalFrame& frame, const FramedRow& arriving, const math::Vec3d& h,
                     const Block& block, double factor) {
  const math::Vec3d normal = frame.world(h);
  const math::Vec3d s = s_axis(vertex.direction, normal, any_normal_to(vertex.direction));
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
  if (lobe.lost > 0) {  // (56)
    const double lost_i = 1 - single_scattering(i.z, lobe.alpha), lost_mean = 1 - mean_single_scattering(lobe.alpha);
    const double factor = lobe.lost * lost_i / lost_mean * cosine_density(i.z);
    result.row.q0 += arriving.row.q0 * lobe.albedo * Lanes(static_cast<float>(factor));
  }
  return result;
}

// Into the embedded base and out again: the boundary polarises both ways, the base does not, (57).
FramedRow from_embedded(const Vertex& vertex, const Lobe& lobe, const FramedRow& arriving, const math::Vec3d& direction,
                        double cos_i) {
  if (cos_i <= 0) return {unpolarized(Lanes(0.0f)), {}, false};
  const math::Vec3d s_o = s_axis(vertex.direction, vertex.normal, any_normal_to(vertex.direction));
  const Row in = arriving.in_frame(vertex.direction, s_o);
  const Lanes entered = lobe.block.a * in.q0 + lobe.block.b * in.q1;
  const Lanes base = entered * lobe.albedo * Lanes(static_cast<float>(cosine_density(cos_i)));
  const Block out = lobe.coating.at(vertex.comb, cos_i).transmitted;
  return {{base * out.a, base * out.b, Lanes(0.0f), Lanes(0.0f)},
          s_axis(direction, vertex.normal, any_normal_to(direction)),
          true};
}

}  // namespace

FramedRow scattered(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const FramedRow& arriving,
                    const math::Vec3d& direction) {
  const math::Vec3d i = frame.local(direction);
  if (lobe.kind == LobeKind::diffuse)
    return {unpolarized(arriving.row.q0 * lobe.albedo * Lanes(static_cast<float>(cosine_density(i.z)))), {}, false};
  if (lobe.kind == LobeKind::embedded) return from_embedded(vertex, lobe, arriving, direction, i.z);
  const math::Vec3d o = clear_of_horizon(frame.local(-vertex.direction));
  if (lobe.kind == LobeKind::rough_mirror) return from_rough_mirror(vertex, frame, lobe, arriving, o, i);
  const double ratio = near_over_far(vertex, lobe);
  const math::Vec3d h = refracting_facet(o, i, ratio);
  const double o_h = math::dot(o, h), i_h = math::dot(i, h);
  if (i.z >= 0 || o_h <= 0 || i_h >= 0) return {unpolarized(Lanes(0.0f)), {}, false};
  const double factor = ggx_visible_density(o, h, lobe.alpha) * refraction_jacobian(o_h, i_h, ratio) *
                        ggx_also_visible_behind(o.z, -i.z, lobe.alpha);
  return from_facet(vertex, frame, arriving, h, lobe.coating.at(vertex.comb, o_h).transmitted, factor);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
