#include "shabon/optics/media.h"

#include <array>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

// Daimon and Masumura 2007, table 2, 20.0 C; formula 2 of refractiveindex.info (main/H2O/nk/Daimon-20.0C).
Medium water() {
  return Medium::formula({2,
                          {0.0, 0.5684027565, 0.005101829712, 0.1726177391, 0.01821153936, 0.02086189578, 0.02620722293,
                           0.1130748688, 10.69792721}},
                         {182, 1129},
                         {"water", "distilled water at 20.0 C",
                          "M. Daimon, A. Masumura, Measurement of the refractive index of distilled water from the "
                          "near-infrared region to the ultraviolet region, Appl. Opt. 46, 3811-3820 (2007); "
                          "coefficients through refractiveindex.info (CC0)"});
}

}  // namespace

std::span<const MediumEntry> media_library() {
  static const std::array<MediumEntry, 3> library = {{
      {"vacuum", Medium()},
      {"air", Medium::constant(1, {"air", "air as an ideal, index exactly 1", "by convention"})},
      {"water", water()},
  }};
  return library;
}

std::vector<std::string_view> media_names() {
  std::vector<std::string_view> names;
  for (const MediumEntry& entry : media_library()) names.push_back(entry.name);
  return names;
}

std::optional<Medium> find_medium(std::string_view name) {
  for (const MediumEntry& entry : media_library())
    if (same_name(entry.name, name)) return entry.medium;
  return {};
}

Result<Medium> medium_named(std::string_view name) {
  if (const auto medium = find_medium(name)) return *medium;
  return fail(Failure::content, unknown_name("medium", name, media_names()));
}

}  // namespace shabon::optics
