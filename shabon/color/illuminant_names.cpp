// Lamps by what a user writes: names of the library, and lamps computed from a temperature.
#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/daylight.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/planck.h"

namespace shabon::color {

namespace {

// `prefix:5000K`.
struct ComputedLamp {
  std::string_view prefix, example, description, source;
  Range range_kelvin;
  Spectrum (*power)(double temperature_kelvin);
};

constexpr ComputedLamp computed_lamps[] = {
    {"blackbody", "blackbody:3000K", "blackbody of ", "computed by Planck's law with the constants of the SI of 2019",
     blackbody_range_kelvin, blackbody_power},
    {"daylight", "daylight:5000K", "daylight of ", "computed from the components of daylight, CIE 15:2018, 4.1.2",
     daylight_range_kelvin, [](double kelvin) { return daylight_power(kelvin); }},
};

std::string whole(double kelvin) { return std::to_string(static_cast<long long>(kelvin)); }

Result<Illuminant> computed(const ComputedLamp& lamp, std::string_view given) {
  std::string_view number = trim(given);
  if (!number.empty() && (number.back() == 'K' || number.back() == 'k'))
    number = trim(number.substr(0, number.size() - 1));
  const std::optional<double> kelvin = parse_number(number);
  if (!kelvin || !lamp.range_kelvin.contains(*kelvin))
    return fail(Failure::content, "expected '" + std::string(lamp.prefix) + ":' and a temperature from " +
                                      whole(lamp.range_kelvin.low) + " to " + whole(lamp.range_kelvin.high) +
                                      " K, got '" + printable(given, 60) + "'");
  const std::string temperature = format_number(*kelvin);
  return Illuminant{std::string(lamp.prefix) + ":" + temperature + "K",
                    std::string(lamp.description) + temperature + " K", std::string(lamp.source), lamp.power(*kelvin)};
}

// FL1 is also written F1, and so on.
bool is_name_of(const Illuminant& lamp, std::string_view given) {
  if (same_name(lamp.name, given)) return true;
  return lamp.name.starts_with("FL") && given.size() + 1 == lamp.name.size() && same_name(given.substr(0, 1), "F") &&
         lamp.name.substr(2) == given.substr(1);
}

std::string unknown_illuminant(std::string_view given) {
  std::vector<std::string_view> names;
  for (const Illuminant& lamp : illuminants()) names.push_back(lamp.name);
  for (const ComputedLamp& lamp : computed_lamps) {
    names.push_back(lamp.prefix);
    names.push_back(lamp.example);
  }
  const std::string text = "unknown illuminant '" + printable(given, 60) + "'";
  const std::size_t colon = given.find(':');
  if (const auto near = nearest_name(given.substr(0, colon), names)) {
    for (const ComputedLamp& lamp : computed_lamps)
      if (*near == lamp.prefix) return text + "; did you mean '" + std::string(lamp.example) + "'?";
    return text + "; did you mean '" + *near + "'?";
  }
  return text + "; known: " + illuminant_forms();
}

}  // namespace

const Illuminant* find_illuminant(std::string_view name) {
  for (const Illuminant& lamp : illuminants())
    if (is_name_of(lamp, name)) return &lamp;
  return nullptr;
}

std::optional<std::string> illuminant_file(std::string_view text) {
  constexpr std::string_view prefix = "file:";
  std::string_view given = trim(text);
  if (!same_name(given.substr(0, prefix.size()), prefix)) return {};
  given = trim(given.substr(prefix.size()));
  const bool quoted = given.size() >= 2 && given.front() == '"' && given.back() == '"';
  return std::string(quoted ? given.substr(1, given.size() - 2) : given);
}

std::string illuminant_forms() {
  // A run of names that differ in their last number only is told by its ends.
  const auto stem = [](std::string_view name) { return name.substr(0, name.find_last_not_of("0123456789") + 1); };
  const std::span<const Illuminant> all = illuminants();
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t last = i;
    const std::string_view common = stem(all[i].name);
    while (last + 1 < all.size() && common.size() > 1 && common.size() < all[i].name.size() &&
           stem(all[last + 1].name) == common)
      ++last;
    text += (text.empty() ? "" : ", ") + all[i].name;
    if (last > i) text += ".." + all[last].name;
    i = last;
  }
  for (const ComputedLamp& lamp : computed_lamps)
    text += ", " + std::string(lamp.example) + " (" + whole(lamp.range_kelvin.low) + ".." +
            whole(lamp.range_kelvin.high) + " K)";
  return text;
}

Result<Illuminant> illuminant_named(std::string_view text) {
  const std::string_view given = trim(text);
  if (const Illuminant* lamp = find_illuminant(given)) return *lamp;
  if (illuminant_file(given))
    return fail(Failure::content, "no file can be read here, got '" + printable(given, 60) + "'");
  const std::size_t colon = given.find(':');
  for (const ComputedLamp& lamp : computed_lamps)
    if (same_name(lamp.prefix, trim(given.substr(0, colon))))
      return computed(lamp, colon == std::string_view::npos ? std::string_view() : given.substr(colon + 1));
  return fail(Failure::content, unknown_illuminant(given));
}

}  // namespace shabon::color
