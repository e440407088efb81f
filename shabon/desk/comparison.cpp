#include "shabon/desk/comparison.h"

#include <algorithm>
#include <cmath>

#include "shabon/color/lab.h"

namespace shabon::desk {

DifferenceSummary summary_of(std::span<const double> thicknesses_nm, std::span<const double> differences) {
  DifferenceSummary summary;
  const std::size_t count = differences.size();
  if (count == 0) return summary;
  std::vector<double> sorted(differences.begin(), differences.end());
  std::sort(sorted.begin(), sorted.end());
  for (const double difference : sorted) summary.mean += difference / static_cast<double>(count);
  summary.median = (sorted[(count - 1) / 2] + sorted[count / 2]) / 2;
  summary.percentile_95 = sorted[(95 * count + 99) / 100 - 1];
  const auto largest = std::max_element(differences.begin(), differences.end());
  summary.largest = *largest;
  summary.largest_at_nm = thicknesses_nm[static_cast<std::size_t>(largest - differences.begin())];
  return summary;
}

Result<Comparison> compare(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer,
                           double brightness) {
  Sweep exact = film;
  exact.interference = optics::Interference::airy;
  Result<std::vector<color::Xyz>> colors = swept_colors(exact, lamp, observer);
  if (!colors) return colors.errors();
  if (!film.stack.layers[film.layer].coherent)
    return fail(Failure::content, "expected a coherent layer to sweep, got an incoherent one: it has no interference");

  const color::Xyz white = color::white_point(lamp, observer);
  const auto lab = [&](color::Xyz colour) {
    return color::xyz_to_lab({colour.x * brightness, colour.y * brightness, colour.z * brightness}, white);
  };
  Comparison comparison{std::move(*colors), {}};
  for (const Shortcut& shortcut : shortcuts()) {
    ShortcutSeries& series = comparison.shortcuts.emplace_back();
    series.shortcut = &shortcut;
    series.unfit = shortcut.unfit(film);
    if (!series.unfit.empty()) continue;
    series.colors = shortcut.colors(film, lamp, observer);
    for (std::size_t t = 0; t < series.colors.size(); ++t)
      series.differences.push_back(color::ciede2000(lab(comparison.exact[t]), lab(series.colors[t])));
    series.summary = summary_of(film.thicknesses_nm, series.differences);
  }
  return comparison;
}

}  // namespace shabon::desk
