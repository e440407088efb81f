#include "shabon/color/adaptation.h"

#include "shabon/base/text.h"

namespace shabon::color {

namespace {

constexpr AdaptationEntry entries[] = {
    {Adaptation::bradford, "bradford", "K. M. Lam 1985, linear as in ICC profiles (ICC.1:2010, annex E)",
     Matrix3{Vector3{0.8951, 0.2664, -0.1614}, Vector3{-0.7502, 1.7135, 0.0367}, Vector3{0.0389, -0.0685, 1.0296}}},
    {Adaptation::cat16, "cat16", "C. Li et al., Color Res. Appl. 42 (2017) 703, one step",
     Matrix3{Vector3{0.401288, 0.650173, -0.051461}, Vector3{-0.250268, 1.204414, 0.045854},
             Vector3{-0.002079, 0.048952, 0.953127}}},
    {Adaptation::cat02, "cat02", "CIECAM02, CIE 159:2004",
     Matrix3{Vector3{0.7328, 0.4296, -0.1624}, Vector3{-0.7036, 1.6975, 0.0061}, Vector3{0.0030, 0.0136, 0.9834}}},
    {Adaptation::von_kries, "von-kries", "J. von Kries 1902 with the cones of Hunt, Pointer and Estevez",
     Matrix3{Vector3{0.40024, 0.70760, -0.08081}, Vector3{-0.22630, 1.16532, 0.04570}, Vector3{0, 0, 0.91822}}},
    {Adaptation::xyz_scaling, "xyz-scaling", "X, Y and Z each by the ratio of the whites",
     Matrix3{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}},
};

}  // namespace

std::span<const AdaptationEntry> adaptations() { return entries; }

std::optional<Adaptation> find_adaptation(std::string_view name) {
  for (const AdaptationEntry& entry : entries)
    if (same_name(entry.name, name)) return entry.method;
  return {};
}

std::string_view name_of(Adaptation method) {
  for (const AdaptationEntry& entry : entries)
    if (entry.method == method) return entry.name;
  return {};
}

Matrix3 adaptation_matrix(Xyz from, Xyz to, Adaptation method) {
  Matrix3 cones = entries[0].xyz_to_cones;
  for (const AdaptationEntry& entry : entries)
    if (entry.method == method) cones = entry.xyz_to_cones;
  const Vector3 seen = multiply(cones, Vector3{from.x, from.y, from.z}),
                wanted = multiply(cones, Vector3{to.x, to.y, to.z});
  const Matrix3 back = inverse(cones);
  for (std::size_t i = 0; i < 3; ++i)
    for (double& value : cones[i]) value *= wanted[i] / seen[i];
  return multiply(back, cones);
}

Xyz adapt(Xyz colour, Xyz from, Xyz to, Adaptation method) {
  const Vector3 result = multiply(adaptation_matrix(from, to, method), Vector3{colour.x, colour.y, colour.z});
  return {result[0], result[1], result[2]};
}

}  // namespace shabon::color
