#include "shabon/color/illuminant.h"

#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/table_columns.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

std::span<const Illuminant> illuminants() {
  static const std::vector<Illuminant> all = [] {
    std::vector<Illuminant> list;
    for (const Table& table : tables::illuminants())
      list.push_back({table.name, table.description, table.source, spectrum_column(table, 1)});
    return list;
  }();
  return all;
}

const Illuminant* find_illuminant(std::string_view name) {
  for (const Illuminant& lamp : illuminants())
    if (same_name(lamp.name, name)) return &lamp;
  return nullptr;
}

Spectrum lamp_radiance(const Illuminant& lamp, const Observer& observer) {
  const double luminance = radiance_to_xyz(lamp.power, observer).y;
  Spectrum radiance;
  for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = lamp.power[i] / luminance;
  return radiance;
}

}  // namespace shabon::color
