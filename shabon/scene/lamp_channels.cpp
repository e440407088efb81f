#include "shabon/scene/lamp_channels.h"

#include "shabon/color/illuminant.h"
#include "shabon/color/rgb_basis.h"

namespace shabon::scene {

int LampChannels::of(const std::string& illuminant, const Path& light) {
  const auto [entry, added] = channel_of_.try_emplace(illuminant, static_cast<int>(spectra.size()));
  if (!added) return entry->second;
  const Path place{&light, "illuminant"};
  color::Spectrum radiance{};
  if (!problems_.has(place)) {
    const Result<color::Illuminant> lamp = resources_.illuminant(illuminant);
    if (lamp) {
      const auto [same, is_new] = channel_of_lamp_.try_emplace(lamp->name, entry->second);
      if (!is_new) return entry->second = same->second;
      radiance = color::lamp_radiance(*lamp);
      if (!lamp->note.empty()) problems_.add_warning(place, lamp->note);
    } else {
      for (const Diagnostic& error : lamp.errors()) problems_.add_from_file(place, error);
    }
  }
  spectra.push_back(radiance);
  return entry->second;
}

int LampChannels::of_picture() {
  const int first = static_cast<int>(spectra.size());
  for (const color::LinearRgb primary : {color::LinearRgb{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
    spectra.push_back(color::rgb_to_radiance(primary));
  return first;
}

}  // namespace shabon::scene
