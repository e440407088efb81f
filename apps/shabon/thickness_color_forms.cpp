// What was found for a colour as text, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "swatch.h"
#include "thickness_by_color.h"

namespace shabon::app {

namespace {

const char* side_name(const desk::SeenColor& seen) {
  return seen.side == desk::Side::reflected ? "reflected" : "transmitted";
}

// Counted from 1; nothing where the layer has no orders.
std::string order_text(const desk::ColorCandidate& candidate) {
  return candidate.order ? std::to_string(static_cast<int>(std::floor(*candidate.order)) + 1) : "";
}

bool has_orders(const ColorFindings& findings) { return findings.answer.candidates.front().order.has_value(); }

std::string heading(const ColorFindings& findings) {
  const desk::Unknown& unknown = findings.film.film.unknowns.front();
  std::string text = printable(findings.command.expression) + "\n";
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    const ToldColor& told = findings.told[i];
    const desk::SeenColor& seen = findings.query.seen[i];
    const color::Lab lab = color::xyz_to_lab(
        told.xyz, seen.white.value_or(color::white_point(findings.query.lamp, *findings.query.observer)));
    text += fmt::format("{} at {} degrees: {}  XYZ {:.4f} {:.4f} {:.4f}  Lab {:.2f} {:.2f} {:.2f}\n", side_name(seen),
                        format_number(findings.incidence_deg[i]), printable(told.text, 60), told.xyz.x, told.xyz.y,
                        told.xyz.z, lab.L, lab.a, lab.b);
  }
  text += fmt::format("unpolarised, lamp {}, observer {}{}\n", printable(findings.lamp, 60), findings.observer,
                      findings.command.ignore_lightness ? ", lightness ignored" : "");
  text += fmt::format("{}: {} to {} nm, all equally likely; uncertainty of the colour {} (CIEDE2000)\n\n",
                      findings.film.names.front(), nm_text(unknown.low_nm), nm_text(unknown.high_nm),
                      format_number(findings.query.uncertainty, 3));
  return text;
}

std::string row(const ColorFindings& findings, const desk::ColorCandidate& c) {
  const bool one = findings.told.size() == 1;
  std::string text = fmt::format("{:>10.2f}", c.thickness_nm);
  if (findings.answer.found)
    text += fmt::format("  {:>9.2f} .. {:<9.2f} {:>8}", c.interval_low_nm, c.interval_high_nm, percent_text(c.weight));
  text += fmt::format("  {:>7.2f}", c.difference);
  if (has_orders(findings)) text += fmt::format("  {:>5}", order_text(c));
  if (one) text += fmt::format("  {:>7.4f} {:>7.4f} {:>7.4f}", c.xyz[0].x, c.xyz[0].y, c.xyz[0].z);
  if (one && findings.command.ignore_lightness) text += fmt::format("  {:>8}", format_number(c.exposure[0], 3));
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    const color::EncodedRgb shown = shown_color(findings, c, i);
    text += "  " + color::to_hex(shown) + (swatch_wanted() ? swatch(shown) : "");
  }
  if (c.level) return text + "  " + level_sentence(c) + "\n";
  return text + (c.at_end ? "  end of the range\n" : "\n");
}

std::string table(const ColorFindings& findings) {
  const bool one = findings.told.size() == 1;
  std::string text = fmt::format("{:>10}", "nm");
  if (findings.answer.found) text += fmt::format("  {:^22} {:>8}", "95 % of its weight", "weight");
  text += fmt::format("  {:>7}", "dE2000");
  if (has_orders(findings)) text += fmt::format("  {:>5}", "order");
  if (one) text += fmt::format("  {:>7} {:>7} {:>7}", "X", "Y", "Z");
  if (one && findings.command.ignore_lightness) text += fmt::format("  {:>8}", "exposure");
  text += one ? "  colour\n" : "  colours\n";
  for (const std::size_t i : findings.listed) text += row(findings, findings.answer.candidates[i]);
  return text;
}

double least_difference_beside(const ColorFindings& findings) {
  const auto& candidates = findings.answer.candidates;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (std::find(findings.listed.begin(), findings.listed.end(), i) == findings.listed.end())
      least = std::min(least, candidates[i].difference);
  return least;
}

// With as many digits as it takes to see that it is more.
std::string told_difference(double difference, double near) {
  int digits = 2;
  while (digits < 6 && parse_number(fmt::format("{:.{}f}", difference, digits)).value_or(0) <= near) ++digits;
  return fmt::format("{:.{}f}", difference, digits);
}

std::string verdict(const ColorFindings& findings) {
  const desk::ColorAnswer& answer = findings.answer;
  if (!answer.found)
    return fmt::format("No thickness in the range gives this colour: the nearest differs by {}, more than {} ({}).\n",
                       told_difference(answer.candidates.front().difference, answer.near),
                       format_number(answer.near, 3),
                       answer.near > desk::noticeable_difference ? "three times the uncertainty" : "just noticeable");
  if (!is_determined(findings))
    return "Undetermined: over wide stretches of thickness the colour is nearly the same.\n";
  return verdict_sentence(answer.in_95_percent) + "\n";
}

// What the table leaves out: how many, how far they are and what they weigh.
std::string unlisted(const ColorFindings& findings) {
  const auto& candidates = findings.answer.candidates;
  const std::size_t left = candidates.size() - findings.listed.size();
  if (left == 0) return "";
  const double least = least_difference_beside(findings);
  std::string text =
      fmt::format("{} more, of difference {:.1f} and above, {} not listed", left, least, left == 1 ? "is" : "are");
  if (findings.answer.found && findings.unlisted_weight >= least_weight_told)
    text += fmt::format(" ({} of the probability)", percent_text(findings.unlisted_weight));
  return text + ".\n";
}

std::string candidate_json(const ColorFindings& findings, const desk::ColorCandidate& candidate) {
  JsonObject json;
  json.add("thickness_nm", candidate.thickness_nm).add("dE2000", candidate.difference);
  json.add_json("order", candidate.order ? order_text(candidate) : "null");
  json.add_json("path_orders", candidate.order ? json_number(*candidate.order) : "null");
  json.add("at_end", candidate.at_end);
  if (findings.answer.found)
    json.add("weight", candidate.weight).add("interval_nm", {candidate.interval_low_nm, candidate.interval_high_nm});
  if (candidate.level)
    json.add("level_nm", {candidate.level->low_nm, candidate.level->high_nm}).add("opaque", candidate.opaque);
  std::string colors;
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    JsonObject color;
    const color::Xyz& xyz = candidate.xyz[i];
    color.add("XYZ", {xyz.x, xyz.y, xyz.z}).add("hex", color::to_hex(shown_color(findings, candidate, i)));
    color.add("exposure", candidate.exposure[i]).add("dE2000", candidate.differences[i]);
    colors += (i == 0 ? "" : ", ") + color.line();
  }
  return json.add_json("colors", "[" + colors + "]").line();
}

}  // namespace

std::string color_findings_text(const ColorFindings& findings) {
  return heading(findings) + table(findings) + "\n" + verdict(findings) + unlisted(findings);
}

std::string color_findings_json(const ColorFindings& findings) {
  const desk::Unknown& unknown = findings.film.film.unknowns.front();
  JsonObject json;
  json.add("stack", findings.command.expression).add("unknown", findings.film.names.front());
  json.add("range_nm", {unknown.low_nm, unknown.high_nm});
  json.add("illuminant", findings.lamp).add("observer", findings.observer);
  json.add("uncertainty", findings.query.uncertainty).add("ignore_lightness", findings.query.ignore_lightness);
  std::string colors, candidates;
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    JsonObject color;
    const color::Xyz& xyz = findings.told[i].xyz;
    color.add("color", findings.told[i].text).add("angle_deg", findings.incidence_deg[i]);
    color.add("side", side_name(findings.query.seen[i])).add("XYZ", {xyz.x, xyz.y, xyz.z});
    colors += (i == 0 ? "" : ", ") + color.line();
  }
  for (const std::size_t i : findings.listed)
    candidates += (candidates.empty() ? "\n    " : ",\n    ") + candidate_json(findings, findings.answer.candidates[i]);
  json.add_json("colors", "[" + colors + "]");
  const std::string_view word =
      is_determined(findings) ? verdict_word(findings.answer.in_95_percent) : std::string_view("undetermined");
  json.add("verdict", findings.answer.found ? word : std::string_view("none"));
  if (findings.answer.found)
    json.add("in_95_percent", findings.answer.in_95_percent).add("unlisted_weight", findings.unlisted_weight);
  json.add("candidates_found", findings.answer.candidates.size());
  return json.add_json("candidates", "[" + candidates + "\n  ]").text();
}

std::string color_findings_csv(const ColorFindings& findings) {
  std::string text = "thickness_nm,low_nm,high_nm,weight,dE2000,order";
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    const std::string suffix = i == 0 ? "" : "_" + std::to_string(i + 1);
    for (const char* name : {"X", "Y", "Z", "hex"}) text += "," + (name + suffix);
  }
  text += "\n";
  for (const std::size_t c : findings.listed) {
    const desk::ColorCandidate& candidate = findings.answer.candidates[c];
    text += format_exact(candidate.thickness_nm);
    for (const double value : {candidate.interval_low_nm, candidate.interval_high_nm, candidate.weight})
      text += "," + (findings.answer.found ? format_exact(value) : "");
    text += "," + format_exact(candidate.difference) + "," + order_text(candidate);
    for (std::size_t i = 0; i < findings.told.size(); ++i) {
      const color::Xyz& xyz = candidate.xyz[i];
      for (const double value : {xyz.x, xyz.y, xyz.z}) text += "," + format_exact(value);
      text += "," + color::to_hex(shown_color(findings, candidate, i));
    }
    text += "\n";
  }
  return text;
}

}  // namespace shabon::app
