// What the numbers of a scene file may be.
#pragma once

#include "shabon/base/field.h"
#include "shabon/optics/stack.h"

namespace shabon::scene {

// Coordinates up to here keep ten digits of a unit in double, enough for interference-smooth normals.
inline constexpr Range coordinate_range{.low = -1e6, .high = 1e6};
inline constexpr Range radius_range{.low = 0, .high = 1e6, .low_open = true};
inline constexpr Range hole_range{.low = 0, .high = 1e6, .high_open = true};
inline constexpr Range tube_range{.low = 0, .high = 1e6, .low_open = true, .high_open = true};  // within a ring
inline constexpr Range angle_range_deg{.low = -36000, .high = 36000};                           // a hundred turns
inline constexpr Range below_half_turn_deg{.low = 0, .high = 180, .low_open = true, .high_open = true};
inline constexpr Range up_to_half_turn_deg{.low = 0, .high = 180, .low_open = true};
inline constexpr Range elevation_range_deg{.low = 0, .high = 90};
inline constexpr Range time_range_s{.low = 0, .high = 1e9};
inline constexpr Range scale_range{.low = 0, .high = 1e9};  // its square still fits a float
inline constexpr Range side_range{.low = 1, .high = 65536};
inline constexpr Range samples_range{.low = 1, .high = 1e6};
inline constexpr Range seed_range{.low = 0};
// Below 1e-7, where a probe cuts too, the tree of paths grows and the picture does not change.
inline constexpr Range split_range{.low = 1e-7, .high = 1};
inline constexpr Range depth_range{.low = 1, .high = 1024};
inline constexpr Range layer_range{.low = 1, .high = optics::most_layers};
inline constexpr double most_pixels = 1 << 28;
inline constexpr Range filter_width_range{.low = 0, .high = 64, .low_open = true};
inline constexpr Range exposure_range{.low = -100, .high = 100};
inline constexpr Range lens_range{.low = 0, .high = 1e6};
inline constexpr Range share_range{.low = 0, .high = 1};
inline constexpr Range stretch_range{.low = 0, .high = 1e6, .low_open = true};  // factors on lengths
inline constexpr Range frame_range{.low = 0, .high = 1e9};
inline constexpr Range frame_rate_range{.low = 0, .high = 1e6, .low_open = true};
inline constexpr Range repeat_range{.low = 0, .high = 1e6, .low_open = true};
inline constexpr Range unit_range_m{.low = 0, .high = 1e9, .low_open = true};

inline constexpr double shortest_vector = 1e-9;  // relative to coordinates around 1; anything shorter is a slip
inline constexpr double parallel_sine = 1e-6;    // a view this near to `up` leaves the picture's rotation open

}  // namespace shabon::scene
