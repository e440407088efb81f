// The spectrum along one ray of a scene with surfaces: the mean of walks at the asked wavelengths, and how sure it is.
#pragma once

#include <span>

#include "shabon/render/kernel/scattering/walk.h"
#include "shabon/render/probe.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// As probe(), with the walks' own start.
ProbeResult probe_walks(const scene::Scene& scene, const WalkStart& start, std::span<const double> wavelengths_nm,
                        const ProbeOptions& options);

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
