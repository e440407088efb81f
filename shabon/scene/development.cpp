#include "shabon/scene/development.h"

namespace shabon::scene {

namespace {

constexpr color::Adaptation method = color::Adaptation::bradford;

// A white under which one kind of cone sees less than this share of what it sees under D65 would turn noise into
// colour.
constexpr double least_response = 0.01;

color::Vector3 cone_responses(const color::Xyz& white) {
  for (const color::AdaptationEntry& entry : color::adaptations())
    if (entry.method == method) return color::multiply(entry.xyz_to_cones, color::Vector3{white.x, white.y, white.z});
  return {};
}

}  // namespace

Result<std::optional<color::Matrix3>> white_balance_for(const color::Illuminant& lamp) {
  const color::Illuminant& d65 = color::illuminants().front();
  if (lamp.power == d65.power) return std::optional<color::Matrix3>();
  const color::Xyz from = color::white_point(lamp), to = color::white_point(d65);
  const color::Vector3 seen = cone_responses(from), wanted = cone_responses(to);
  for (std::size_t i = 0; i < 3; ++i)
    if (!(seen[i] >= least_response * wanted[i]))
      return fail(Failure::content, "expected a lamp whose light can be taken for white, got '" + lamp.name +
                                        "', whose colour is too saturated");
  return std::optional(color::adaptation_matrix(from, to, method));
}

}  // namespace shabon::scene
