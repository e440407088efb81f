#include "compare_report.h"

#include <fmt/format.h>

#include "chart_colors.h"
#include "json.h"
#include "shabon/base/text.h"

namespace shabon::app {

namespace {

constexpr double least_shown = 0.005;  // what is printed as 0.01

double step_nm(const CompareReport& report) {
  const std::vector<double>& all = report.sweep.thicknesses_nm;
  return all.size() < 2 ? 0 : all[1] - all[0];
}

std::string thickness_line(const CompareReport& report) {
  const std::vector<double>& all = report.sweep.thicknesses_nm;
  return fmt::format("{} of {} to {} nm in steps of {} nm: {} films",
                     report.film.stack.layers.size() > 1 ? fmt::format("layer {}", report.film.layer + 1) : "thickness",
                     format_number(all.front()), format_number(all.back()), format_number(step_nm(report), 6),
                     all.size());
}

// One shortcut with all its numbers.
std::string series_json(const desk::ShortcutSeries& series) {
  JsonObject json;
  json.add("name", series.shortcut->name).add("description", series.shortcut->description);
  json.add("used_by", series.shortcut->used_by);
  if (!series.unfit.empty()) return json.add("unfit", series.unfit).line();
  const desk::DifferenceSummary& summary = series.summary;
  json.add("mean", summary.mean).add("median", summary.median).add("percentile_95", summary.percentile_95);
  json.add("max", summary.largest).add("max_at_nm", summary.largest_at_nm);
  return json.add("dE2000", series.differences).line();
}

std::string xyz_json(const std::vector<color::Xyz>& colors) {
  std::string text;
  for (const color::Xyz& c : colors) text += (text.empty() ? "" : ", ") + json_numbers({c.x, c.y, c.z});
  return "[" + text + "]";
}

}  // namespace

std::string compare_conditions(const CompareReport& report) {
  std::string text =
      fmt::format("{} at {}\u00B0, unpolarised, lamp {}, observer {}", name_of(report.sweep.side),
                  format_number(report.incidence_deg), printable(report.lamp.name, 60), report.observer->name);
  if (report.brightness != 1) text += fmt::format(", brightened \u00D7 {}", format_number(report.brightness, 4));
  return text;
}

std::string compare_text(const CompareReport& report) {
  std::string text = title_text(report.film) + "\n" + compare_conditions(report) + "\n" + thickness_line(report) + "\n";
  text += "\nDifference from the exact colour, CIEDE2000 (1 is about the least that one sees side by side):\n";
  text += fmt::format("{:<20}{:>9}{:>9}{:>9}{:>9}{:>11}\n", "shortcut", "mean", "median", "95 %", "max", "at nm");
  for (const desk::ShortcutSeries& series : report.comparison.shortcuts) {
    const desk::DifferenceSummary& s = series.summary;
    text += fmt::format("{:<20}", series.shortcut->name);
    if (!series.unfit.empty()) {
      text += fmt::format("  {}\n", series.unfit);
      continue;
    }
    text += fmt::format("{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}", s.mean, s.median, s.percentile_95, s.largest);
    text += s.largest < least_shown ? "\n" : fmt::format("{:>11}\n", format_number(s.largest_at_nm, 6));
  }
  text += "\n";
  for (const desk::ShortcutSeries& series : report.comparison.shortcuts)
    text += fmt::format("{:<20}{}\n{:20}in {}\n", series.shortcut->name, series.shortcut->description, "",
                        series.shortcut->used_by);
  return text;
}

std::string compare_csv(const CompareReport& report) {
  std::string csv = "# How far shortcuts are from the exact colour of the film " + printable(report.film.expression) +
                    "\n# " + compare_conditions(report) + "\n";
  csv += fmt::format("# thickness_nm: of layer {}\n", report.film.layer + 1);
  csv += fmt::format("# X, Y, Z: the exact colour; the lamp itself has Y = 1; {}; not adapted\n", film_sums);
  std::string head = "thickness_nm,X,Y,Z";
  std::vector<const desk::ShortcutSeries*> columns;
  for (const desk::ShortcutSeries& series : report.comparison.shortcuts) {
    csv += fmt::format("# {}: {}\n", series.shortcut->name,
                       series.unfit.empty() ? fmt::format("CIEDE2000 difference; {}", series.shortcut->description)
                                            : fmt::format("left out, {}", series.unfit));
    if (!series.unfit.empty()) continue;
    columns.push_back(&series);
    head += fmt::format(",{}", series.shortcut->name);
  }
  csv += head + "\n";
  for (std::size_t t = 0; t < report.sweep.thicknesses_nm.size(); ++t) {
    const color::Xyz& exact = report.comparison.exact[t];
    csv += format_number(report.sweep.thicknesses_nm[t]);
    for (const double value : {exact.x, exact.y, exact.z}) csv += "," + format_exact(value);
    for (const desk::ShortcutSeries* series : columns) csv += "," + format_exact(series->differences[t]);
    csv += "\n";
  }
  return csv;
}

std::string compare_json(const CompareReport& report) {
  std::string list;
  for (const desk::ShortcutSeries& series : report.comparison.shortcuts)
    list += (list.empty() ? "\n    " : ",\n    ") + series_json(series);
  JsonObject json;
  json.add("stack", report.film.expression).add("layer", report.film.layer + 1);
  json.add("side", name_of(report.sweep.side)).add("angle_deg", report.incidence_deg);
  json.add("illuminant", report.lamp.name).add("observer", report.observer->name);
  json.add("brightness", report.brightness).add("thickness_nm", report.sweep.thicknesses_nm);
  json.add_json("XYZ", xyz_json(report.comparison.exact)).add_json("shortcuts", "[" + list + "\n  ]");
  return json.text();
}

}  // namespace shabon::app
