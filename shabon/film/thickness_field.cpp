#include "shabon/film/thickness_field.h"

namespace shabon::film {

ThicknessField at_time(const ThicknessModel& model, double seconds) {
  return std::visit([&](const auto& chosen) { return ThicknessField(detail::ready(chosen, seconds)); }, model);
}

}  // namespace shabon::film
