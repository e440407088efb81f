// What a surface does with light from the eye's side: a few lobes, each one way for it to go on. Smooth lobes know one
// direction; the others are sampled, and evaluated towards lamps.
#pragma once

#include <cstdint>

#include "shabon/geometry/shape.h"
#include "shabon/render/kernel/scattering/frame.h"
#include "shabon/render/kernel/scattering/tables.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// A ray's arrival at a surface.
struct Vertex {
  geometry::SurfacePoint at;
  math::Vec3d direction;  // of the ray, away from the eye
  math::Vec3d normal;     // on the side the ray comes from
  bool from_back = false;
  double cos_o = 1;  // between the normal and the way back to the eye
  std::size_t comb = 0;
  int hero = 0;           // the lane that is left where wavelengths part
  bool one_lane = false;  // only the hero is left
};

enum class LobeKind : std::uint8_t {
  mirror,           // smooth: the mirrored direction
  straight,         // smooth: straight on
  refracted,        // smooth: the refracted direction
  rough_mirror,     // GGX reflection
  rough_refracted,  // GGX refraction
  diffuse,          // Lambert
  embedded,         // Lambert under a boundary
};

constexpr bool is_smooth(LobeKind kind) { return kind <= LobeKind::refracted; }

// A coating at one place.
struct CoatingHere {
  const CoatingTable* table = nullptr;
  bool from_back = false;
  double thickness_nm = -1;  // of the layer that varies; negative: as in the table

  optics::FilmMueller<lane_count> at(std::size_t comb, double cos) const;
  // Into what lies under the boundary, which gets all that a rough boundary does not mirror.
  Block entering(std::size_t comb, double cos, float alpha) const;
  // What rough facets leave over; `behind` turns to the other side of the boundary.
  const RestTable& rest_table(bool behind) const { return from_back != behind ? table->back_rest : table->front_rest; }
  Lanes rest(std::size_t comb, double cos, float alpha, bool behind = false) const;
  Lanes mean_rest(std::size_t comb, float alpha, bool behind = false) const;
  BoundaryPowers diffuse_means(std::size_t comb) const { return table->diffuse_means(comb, thickness_nm); }
  // Near over far at one wavelength.
  double index_ratio(std::size_t comb, int lane) const;
};

struct Lobe {
  LobeKind kind = LobeKind::mirror;
  bool parts_wavelengths = false;  // the direction depends on the wavelength: only the hero goes on
  Block block;                     // smooth and embedded lobes; rough ones: about
  Lanes albedo{0.0f};              // diffuse: the reflectance; embedded and rough ones: see lobes_of.cpp
  float alpha = 0;
  float lost = 0;  // rough ones: the part that carries what single scattering loses, about, (56) and (62)
  CoatingHere coating;
  float share = 1;     // of the surface, where several are mixed
  float estimate = 0;  // about what goes on this way, of the row that arrives
  float chance = 1;    // with which it is followed
  bool followed = true;
  std::int16_t film_slot = -1;  // free films: the next one on the same spot
};

inline constexpr int most_lobes = 16;

struct Lobes {
  Lobe lobe[most_lobes];
  int count = 0;
  Lanes emitted{0.0f};  // radiance towards the eye
  bool emits = false;

  Lobe* add() { return count < most_lobes ? &lobe[count++] : nullptr; }
};

// All ways on from a surface; `film_slot` is the free film that is met, of those on one spot, or -1 for the first.
void lobes_of(const ScatteringTables& tables, const Vertex& vertex, int shape, int film_slot, Lobes& lobes);

// The direction of a smooth lobe; false where it does not exist at the hero's wavelength (total reflection).
bool smooth_direction(const Vertex& vertex, const Lobe& lobe, math::Vec3d& direction);

// Rough lobes: a direction, never on the wrong side of the surface (then false).
bool sample(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, double u1, double u2, double u3,
            math::Vec3d& direction);
// Its density per solid angle.
double density(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const math::Vec3d& direction);
// The row behind the lobe for light from `direction`: the lobe's value times the cosine.
FramedRow scattered(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, const FramedRow& arriving,
                    const math::Vec3d& direction);

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
