// How much of the interference of a film is computed.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "shabon/base/text.h"

namespace shabon::optics {

enum class Interference {
  airy,      // all internal reflections, exact
  two_beam,  // the two beams of the 1989 paper
  none,      // intensities without phase
};

struct InterferenceEntry {
  Interference value;
  std::string_view name;
  std::string_view description;
};

// The closed set, in the order of the enumeration. Flags, scene keys and listings follow from it.
inline constexpr std::array<InterferenceEntry, 3> interference_models = {{
    {Interference::airy, "airy", "exact: every internal reflection, amplitudes and polarisation"},
    {Interference::two_beam, "two-beam", "the 1989 paper: the first two reflected beams, averages at each wall"},
    {Interference::none, "none", "intensities of all internal reflections, summed without phase"},
}};

constexpr std::string_view name_of(Interference model) {
  return interference_models[static_cast<std::size_t>(model)].name;
}

// The model of that name; names ignore case.
inline std::optional<Interference> find_interference(std::string_view name) {
  for (const InterferenceEntry& entry : interference_models)
    if (same_name(entry.name, name)) return entry.value;
  return {};
}

}  // namespace shabon::optics
