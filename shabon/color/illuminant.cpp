#include "shabon/color/illuminant.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/daylight.h"
#include "shabon/color/table_columns.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

namespace {

Spectrum copy(SpectrumView values) {
  Spectrum spectrum;
  std::copy(values.begin(), values.end(), spectrum.begin());
  return spectrum;
}

// What the lamps of a series are, from the first up to the one that opens the next group (CIE 15:2018, 4.3 and 4.4).
struct LampGroup {
  std::string_view first, description;
};

constexpr LampGroup lamp_groups[] = {
    {"FL1", "fluorescent lamp, standard"},
    {"FL7", "fluorescent lamp, broad band"},
    {"FL10", "fluorescent lamp, three narrow bands"},
    {"FL3.1", "fluorescent lamp, standard halophosphate"},
    {"FL3.4", "fluorescent lamp, DeLuxe"},
    {"FL3.7", "fluorescent lamp, three bands"},
    {"FL3.12", "fluorescent lamp, several bands"},
    {"FL3.15", "fluorescent lamp, simulator of D65"},
    {"LED-B1", "white LED, blue with phosphor"},
    {"LED-BH1", "white LED, blue with phosphor, and red"},
    {"LED-RGB1", "white LED, red, green and blue"},
    {"LED-V1", "white LED, violet with phosphor"},
};

void add_series(const Table& table, std::vector<Illuminant>& list) {
  std::string_view description;
  for (std::size_t column = 1; column < table.columns.size(); ++column) {
    const std::string_view name = table.column_names[column];
    for (const LampGroup& group : lamp_groups)
      if (group.first == name) description = group.description;
    list.push_back({std::string(name), "CIE " + std::string(description) + "; 380..780 nm", std::string(table.source),
                    copy(spectrum_column(table, column))});
  }
}

Illuminant nominal_daylight(std::string_view name, double nominal_kelvin) {
  const double kelvin = nominal_kelvin * nominal_daylight_scale;
  return {std::string(name),
          "CIE illuminant " + std::string(name) + ", daylight of about " + format_number(kelvin, 4) + " K",
          "computed from the components of daylight, CIE 15:2018, 4.1.2",
          daylight_power(kelvin, DaylightWeights::three_decimals)};
}

std::vector<Illuminant> library() {
  std::vector<Illuminant> list;
  for (const Table& table : tables::illuminants())
    list.push_back({std::string(table.name), std::string(table.description), std::string(table.source),
                    copy(spectrum_column(table, 1))});
  list.push_back(nominal_daylight("D55", 5500));
  list.push_back(nominal_daylight("D75", 7500));
  for (const Table& table : tables::lamp_series()) add_series(table, list);
  return list;
}

// Samples from one wavelength to the next, and what is wrong with them.
std::string problem_with(std::span<const double> wavelengths_nm, std::span<const double> powers) {
  if (wavelengths_nm.size() != powers.size() || powers.size() < 2)
    return "expected at least two samples, got " + std::to_string(powers.size());
  for (std::size_t i = 0; i < powers.size(); ++i) {
    if (!std::isfinite(wavelengths_nm[i]) || !(wavelengths_nm[i] > 0)) return "expected wavelengths > 0 nm";
    if (i > 0 && !(wavelengths_nm[i] > wavelengths_nm[i - 1])) return "expected rising wavelengths";
    if (!std::isfinite(powers[i]) || powers[i] < 0) return "expected powers >= 0";
  }
  return {};
}

}  // namespace

std::span<const Illuminant> illuminants() {
  static const std::vector<Illuminant> all = library();
  return all;
}

Result<Illuminant> illuminant_from_samples(std::string name, std::string source, std::span<const double> wavelengths_nm,
                                           std::span<const double> powers) {
  if (std::string problem = problem_with(wavelengths_nm, powers); !problem.empty())
    return fail(Failure::content, std::move(problem));
  const double low = wavelengths_nm.front(), high = wavelengths_nm.back();
  Illuminant lamp{std::move(name),
                  "lamp from " + format_number(low) + ".." + format_number(high) + " nm in " +
                      std::to_string(powers.size()) + " samples",
                  std::move(source)};
  std::size_t right = 1;
  double largest = 0;
  for (std::size_t i = 0; i < lamp.power.size(); ++i) {
    const double nm = wavelength_nm(i);
    if (nm < low || nm > high) continue;
    while (wavelengths_nm[right] < nm) ++right;
    const double share = (nm - wavelengths_nm[right - 1]) / (wavelengths_nm[right] - wavelengths_nm[right - 1]);
    lamp.power[i] = powers[right - 1] * (1 - share) + powers[right] * share;
    largest = std::max(largest, lamp.power[i]);
  }
  if (!(largest > 0)) return fail(Failure::content, "the lamp gives no light between 360 and 830 nm");
  // Any scale will do; this one keeps the sums over the observer from overflow and underflow.
  constexpr double highest = 100;
  for (double& power : lamp.power) power *= highest / largest;
  if (low > first_nm || high < last_nm)
    lamp.note = "lamp '" + lamp.name + "' is given for " + format_number(low) + ".." + format_number(high) +
                " nm and taken as zero in the rest of 360..830 nm";
  return lamp;
}

Spectrum lamp_radiance(const Illuminant& lamp, const Observer& observer) {
  const double luminance = radiance_to_xyz(lamp.power, observer).y;
  Spectrum radiance;
  for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = lamp.power[i] / luminance;
  return radiance;
}

}  // namespace shabon::color
