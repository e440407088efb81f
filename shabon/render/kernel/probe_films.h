// What a scene's films do to light along one exact ray: Mueller blocks in double precision, for a group of wavelengths
// at once.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "shabon/optics/packet/stack.h"
#include "shabon/scene/scene.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

inline constexpr int probe_lanes = 32;
using ProbeLanes = math::packet<double, probe_lanes>;
using ProbeMueller = optics::FilmMueller<probe_lanes, double>;

// At most probe_lanes wavelengths; the lanes that are left over repeat the last one.
struct WavelengthGroup {
  std::array<double, probe_lanes> nm;
  explicit WavelengthGroup(std::span<const double> wavelengths_nm);  // not empty
};

class ProbeFilms {
 public:
  ProbeFilms(const scene::Scene& scene, const WavelengthGroup& wavelengths);

  // Film `index` of the scene, its varied layer of this thickness, at cos_i > 0; r as seen from the outside or the
  // inside.
  ProbeMueller blocks(std::size_t index, double thickness_nm, double cos_i, bool from_inside) const;

 private:
  struct Film {
    std::array<std::complex<double>, probe_lanes> n;  // of the first layer
    bool free =
        false;  // the real form (10) holds: one layer, exact interference, no loss, no angle of total reflection
    std::optional<optics::StackTable> stack;  // exact interference where it does not
    std::size_t varied_layer = 0;
    ProbeLanes n2_squared;
    optics::FreeFilmIndices<ProbeLanes> indices;
  };

  ProbeMueller free_film(const Film& film, double thickness_nm, double cos_i) const;
  ProbeMueller by_reference(const Film& film, double thickness_nm, double cos_i) const;

  optics::Interference interference_;
  WavelengthGroup wavelengths_;
  std::array<std::complex<double>, probe_lanes> n1_;
  ProbeLanes n1_squared_;
  std::vector<Film> films_;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
