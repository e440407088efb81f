// What thickness models of physics take of a bubble and its liquid: ranges of their parameters.
#pragma once

#include "shabon/base/field.h"

namespace shabon::film {

inline constexpr double standard_gravity_m_s2 = 9.80665;  // by definition, CGPM 1901

inline constexpr Range bubble_radius_range_m{.low = 1e-4, .high = 1};
inline constexpr Range liquid_density_range_kg_m3{.low = 500, .high = 2000};
inline constexpr Range liquid_viscosity_range_pa_s{.low = 1e-4, .high = 10};  // pure glycerol at 20 degrees C: 1.4
inline constexpr Range film_elasticity_range_n_m{.low = 5e-4, .high = 1};
inline constexpr Range film_age_range_s{.low = 0, .high = 1e9};

}  // namespace shabon::film
