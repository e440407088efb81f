// Chromatic adaptation, equation (44): the colour that looks under one white as a given one does under another. Only on
// request; nothing in this library adapts by itself.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "shabon/color/matrix3.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

enum class Adaptation { bradford, cat16, cat02, von_kries, xyz_scaling };

struct AdaptationEntry {
  Adaptation method;
  std::string_view name, description;
  Matrix3 xyz_to_cones;
};

// All of them; the one to take when in doubt first.
std::span<const AdaptationEntry> adaptations();

// By name, ignoring case.
std::optional<Adaptation> find_adaptation(std::string_view name);
std::string_view name_of(Adaptation method);

// Complete adaptation (D = 1): `from` becomes `to`. The whites are positive, such as white_point() gives.
Matrix3 adaptation_matrix(Xyz from, Xyz to, Adaptation method);
Xyz adapt(Xyz colour, Xyz from, Xyz to, Adaptation method);

}  // namespace shabon::color
