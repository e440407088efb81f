// The boundary of dielectrics, conductors and glossy surfaces: what the kernel needs to know of it, per comb.
#pragma once

#include <memory>
#include <vector>

#include "shabon/optics/packet/stack.h"
#include "shabon/render/kernel/scattering/rest_table.h"
#include "shabon/scene/surfaces/coating.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

struct CoatingTable {
  optics::StackTable front, back;  // from the front and from the back; all combs one after the other
  const scene::Coating* coating = nullptr;
  bool opaque = false;                   // what lies behind absorbs: light never comes from there
  bool one_direction = true;             // refraction is the same at all wavelengths
  std::vector<LanesD> index_ratio = {};  // front over back, per comb
  int space_in_front = 0, space_behind = 0;
  std::vector<Lanes> n_behind_squared = {};      // relative to the front, per comb
  std::vector<BoundaryPowers> front_means = {};  // of diffuse light, per comb; empty where the thickness varies
  RestTable front_rest = {}, back_rest = {};     // empty where nothing is rough

  bool bends() const { return !(one_direction && std::abs(index_ratio[0][0] - 1) < 1e-9); }
  // A ray from one side; thickness_nm is that of the layer that varies, negative for the table's own.
  optics::StackRay ray(bool from_back, double cos, double thickness_nm) const;
  // R and T of unpolarised light.
  BoundaryPowers powers(bool from_back, std::size_t comb, double cos, double thickness_nm) const;
  // Their means over a diffuse field.
  BoundaryPowers diffuse_means(std::size_t comb, double thickness_nm) const;
};

// What the facets of a rough boundary leave over is for.
enum class RestGoes {
  nowhere,  // into a medium that absorbs it
  spread,   // back and through
  behind,   // to what lies under the boundary
};

// `space_of` numbers the media that light runs through.
std::unique_ptr<CoatingTable> coating_table(const scene::Coating& coating, const scene::NumberTexture& roughness,
                                            RestGoes rest, const std::vector<Comb>& combs,
                                            const std::function<int(const optics::Medium&)>& space_of);

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
