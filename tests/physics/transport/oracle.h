// An independent slow answer to what arrives along a ray. It follows the light forward: the 3x3 coherency matrix of the
// electric field, <E_i conj(E_j)> in world coordinates, is carried from the lamps to the eye through every film of the
// tree; nothing is ever turned from frame to frame. It reads the scene's description, not the compiled scene.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "shabon/scene/scene_desc.h"

namespace shabon::oracle {

struct Ray {
  math::Vec3d origin, direction;   // away from the eye; any length but 0
  bool through_polarizer = false;  // the camera's, if it has one
};

struct Limits {
  double least_carried = 1e-7;    // a branch that carries less is cut: the film passes R + T straight on
  int most_events = 1 << 17;      // so is one that has met this many films
  int most_two_beam_events = 16;  // the paper's model drops what needs more
};

struct Answer {
  std::vector<double> radiance;  // per nm, one per wavelength
  // The same sum from the eye's side: each lamp's light times what its branch carries. Equal but for rounding.
  std::vector<double> from_the_eye;
  std::uint64_t events = 0, cut = 0;
};

Answer arriving(const scene::SceneDesc& scene, const Ray& ray, const std::vector<double>& wavelengths_nm,
                const Limits& limits = {});

}  // namespace shabon::oracle
