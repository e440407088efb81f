// The spectrum that arrives along one exact ray. Of bubbles under lamps at infinity: the whole split tree, in double
// precision from the optics reference, without random numbers. Of scenes with surfaces: the mean of many walks of the
// renderer's kernel at the asked wavelengths, with its standard error.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/math/vec.h"
#include "shabon/scene/scene.h"

namespace shabon::render {

struct ProbeRay {
  math::Vec3d origin;
  math::Vec3d direction;        // away from the eye; any length but 0
  bool through_camera = false;  // then the camera's polariser, if it has one, lies before the eye
};

// The ray through the point (x, y) of the picture, counted in pixels from its top left corner, and the middle of the
// lens.
ProbeRay pixel_ray(const scene::Scene& scene, double x, double y);

// Where chance is needed.
struct ProbeOptions {
  std::size_t samples = 4096;
  std::uint64_t seed = 1;
};

struct ProbeResult {
  std::vector<double> radiance;  // per nm, one per wavelength; its sum with ybar over 360..830 nm at 1 nm is Y
  // Of the radiance, one per wavelength; empty where no random numbers were needed, 0 where they made no difference.
  // Wavelengths of one walk share their chances: their errors are not independent.
  std::vector<double> standard_error;
  std::uint64_t film_events = 0;   // of all trees; up to 32 wavelengths share one
  std::uint64_t cut_branches = 0;  // where the film passed R + T straight on, equation (27)
  double least_carried =
      0;  // below this share at all wavelengths a branch was cut: 1e-7, or more where the tree is large
  // No more than this share of the light was passed straight on instead of being reflected: what the cut may have cost,
  // relative to the brightest light of the scene, at the worst wavelength.
  double cut_carried = 0;
  std::uint64_t dropped_samples = 0;  // walks left out because they met numbers that are not finite
};

// Several wavelengths are computed on as many threads as there are cores; the result does not depend on their number.
// wavelengths_nm lie within 360..830. Errors: a direction without length, numbers that are not finite, a wavelength
// outside that range.
Result<ProbeResult> probe(const scene::Scene& scene, const ProbeRay& ray, std::span<const double> wavelengths_nm,
                          const ProbeOptions& options = {});

}  // namespace shabon::render
