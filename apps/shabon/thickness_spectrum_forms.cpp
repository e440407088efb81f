// What was found for a spectrum as text, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "thickness_by_spectrum.h"

namespace shabon::app {

namespace {

constexpr std::size_t narrowest = 12;  // column of a thickness

std::string wavelength_range(const std::vector<desk::MeasuredRow>& rows) {
  double low = rows.front().wavelength_nm, high = low;
  for (const desk::MeasuredRow& row : rows)
    low = std::min(low, row.wavelength_nm), high = std::max(high, row.wavelength_nm);
  return low == high ? format_number(low) : format_number(low) + " to " + format_number(high);
}

// "0, 30, 60", or where there are many "0 to 70".
std::string angle_list(const std::vector<desk::MeasuredRow>& rows) {
  constexpr std::size_t most_listed = 6;
  std::set<double> angles;
  for (const desk::MeasuredRow& row : rows) angles.insert(row.incidence_deg);
  if (angles.size() > most_listed) return format_number(*angles.begin()) + " to " + format_number(*angles.rbegin());
  std::string text;
  for (const double angle : angles) text += (text.empty() ? "" : ", ") + format_number(angle);
  return text;
}

// What is left of an exact film is rounding.
std::string rms_text(double rms) {
  constexpr double rounding = 1e-10;
  return rms < rounding ? "< 1e-10" : format_number(rms, 4);
}

std::string quantity_names(const desk::MeasuredSpectrum& measured) {
  std::string names;
  for (const desk::Quantity quantity : measured.quantities)
    names += (names.empty() ? "" : ", ") + std::string(desk::quantities()[static_cast<std::size_t>(quantity)].name);
  return names;
}

bool noise_is_stated(const SpectrumFindings& findings) {
  return findings.command.noise && !findings.answer.noise_exceeded;
}

std::string noise_line(const SpectrumFindings& findings) {
  const desk::SpectrumAnswer& answer = findings.answer;
  if (noise_is_stated(findings)) return fmt::format("noise of a share {} (stated)\n", format_number(answer.noise, 3));
  return fmt::format("noise of a share about {} (from the residuals; at least {})\n", format_number(answer.noise, 2),
                     format_number(answer.least_noise, 2));
}

std::string heading(const SpectrumFindings& findings) {
  const desk::MeasuredSpectrum& measured = findings.query.measured;
  std::string text = printable(findings.command.expression) + "\n";
  text += fmt::format("{}: {} at {} nm, {} degrees; {} rows\n", printable(*findings.command.spectrum_file, 100),
                      quantity_names(measured), wavelength_range(measured.rows), angle_list(measured.rows),
                      measured.rows.size());
  for (std::size_t j = 0; j < findings.film.names.size(); ++j) {
    const desk::Unknown& unknown = findings.film.film.unknowns[j];
    text += fmt::format("{}: {} to {} nm, all equally likely\n", findings.film.names[j], nm_text(unknown.low_nm),
                        nm_text(unknown.high_nm));
  }
  return text + noise_line(findings) + "\n";
}

// Digits that the error leaves, at most four decimals.
std::string with_error(double value, std::optional<double> error) {
  const double digits = error && *error > 0 ? 1 - std::floor(std::log10(*error)) : 2;
  return fmt::format("{:.{}f}", value, static_cast<int>(std::clamp(digits, 0.0, 4.0)));
}

std::string error_text(std::optional<double> error) {
  constexpr double whole = 10;
  if (!error) return "?";
  return *error >= whole ? fmt::format("{:.0f}", *error) : format_number(*error, 2);
}

std::string table(const SpectrumFindings& findings) {
  const bool scaled = findings.command.ignore_scale;
  std::string text;
  std::vector<std::size_t> widths;
  for (const std::string& name : findings.film.names) {
    widths.push_back(std::max(narrowest, name.size() + 3));
    text += fmt::format("  {:>{}}  {:<8} {:<8}", name + " nm", widths.back(), "+-", "95 %");
  }
  text += fmt::format("  {:>10}{}  {:>8}\n", "rms", scaled ? "     scale" : "", "weight");
  for (const std::size_t i : findings.listed) {
    const desk::SpectrumCandidate& c = findings.answer.candidates[i];
    for (std::size_t j = 0; j < widths.size(); ++j)
      text += fmt::format("  {:>{}}  {:<8} {:<8}", with_error(c.thickness_nm[j], c.standard_error_nm[j]), widths[j],
                          error_text(c.standard_error_nm[j]), error_text(c.half_95_nm[j]));
    text += fmt::format("  {:>10}", rms_text(c.rms));
    if (scaled) text += fmt::format("  {:>8}", format_number(c.scale, 4));
    const bool at_end = std::find(c.at_end.begin(), c.at_end.end(), true) != c.at_end.end();
    text += fmt::format("  {:>8}{}\n", percent_text(c.weight), at_end ? "  end of the range" : "");
  }
  return text;
}

std::string correlations(const SpectrumFindings& findings) {
  const desk::SpectrumCandidate& best = most_probable(findings);
  if (best.correlation.size() < 2) return "";
  std::string text = "correlation of the errors of the first\n";
  std::size_t width = 0;
  for (const std::string& name : findings.film.names) width = std::max(width, name.size());
  for (std::size_t j = 0; j < best.correlation.size(); ++j) {
    text += fmt::format("  {:<{}}", findings.film.names[j], width);
    for (const double value : best.correlation[j]) text += fmt::format("  {:>6.3f}", value);
    text += "\n";
  }
  return text + "\n";
}

bool is_determined(const SpectrumFindings& findings) {
  const auto& errors = most_probable(findings).standard_error_nm;
  return std::all_of(errors.begin(), errors.end(),
                     [](const std::optional<double>& error) { return error.has_value(); });
}

std::string json_or_null(std::optional<double> value) { return value ? json_number(*value) : "null"; }

std::string candidate_json(const desk::SpectrumCandidate& c) {
  std::string errors, halves, ends, correlation;
  for (std::size_t j = 0; j < c.thickness_nm.size(); ++j) {
    errors += (j == 0 ? "" : ", ") + json_or_null(c.standard_error_nm[j]);
    halves += (j == 0 ? "" : ", ") + json_or_null(c.half_95_nm[j]);
    ends += std::string(j == 0 ? "" : ", ") + (c.at_end[j] ? "true" : "false");
  }
  for (std::size_t j = 0; j < c.correlation.size(); ++j)
    correlation += (j == 0 ? "" : ", ") + json_numbers(c.correlation[j]);
  JsonObject json;
  json.add("thickness_nm", c.thickness_nm).add_json("standard_error_nm", "[" + errors + "]");
  json.add_json("half_95_nm", "[" + halves + "]");
  json.add("rms", c.rms).add("weight", c.weight).add("scale", c.scale).add_json("at_end", "[" + ends + "]");
  return json.add_json("correlation", "[" + correlation + "]").line();
}

double least_rms_beside(const SpectrumFindings& findings) {
  const auto& candidates = findings.answer.candidates;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (std::find(findings.listed.begin(), findings.listed.end(), i) == findings.listed.end())
      least = std::min(least, candidates[i].rms);
  return least;
}

std::string angles_json(const SpectrumFindings& findings) {
  std::set<double> angles;
  for (const desk::MeasuredRow& row : findings.query.measured.rows) angles.insert(row.incidence_deg);
  return json_numbers(std::vector<double>(angles.begin(), angles.end()));
}

const char* angles_from(const SpectrumFindings& findings) {
  if (findings.query.measured.has_angles) return "file";
  return findings.command.incidence_deg.empty() ? "assumption" : "statement";
}

}  // namespace

std::string spectrum_findings_text(const SpectrumFindings& findings) {
  std::string text = heading(findings) + table(findings) + "\n" + correlations(findings);
  text += is_determined(findings) ? verdict_sentence(findings.answer.in_95_percent)
                                  : "Undetermined: many thicknesses fit alike, of which one is listed.";
  text += "\n";
  const std::size_t left = findings.answer.candidates.size() - findings.listed.size();
  if (left == 0) return text;
  text += fmt::format("{} more, of rms {} and above, {} not listed", left, format_number(least_rms_beside(findings), 3),
                      left == 1 ? "is" : "are");
  if (findings.unlisted_weight >= least_weight_told)
    text += fmt::format(" ({} of the probability)", percent_text(findings.unlisted_weight));
  text += ".\n";
  return text;
}

std::string spectrum_findings_json(const SpectrumFindings& findings) {
  const desk::MeasuredSpectrum& measured = findings.query.measured;
  std::string unknowns, quantities, candidates;
  for (std::size_t j = 0; j < findings.film.names.size(); ++j) {
    const desk::Unknown& unknown = findings.film.film.unknowns[j];
    JsonObject json;
    json.add("medium", findings.film.names[j]).add("layer", unknown.layers.front() + 1);
    json.add("range_nm", {unknown.low_nm, unknown.high_nm});
    unknowns += (j == 0 ? "" : ", ") + json.line();
  }
  for (const desk::Quantity quantity : measured.quantities)
    quantities +=
        (quantities.empty() ? "" : ", ") + json_string(desk::quantities()[static_cast<std::size_t>(quantity)].name);
  for (const std::size_t i : findings.listed)
    candidates += (candidates.empty() ? "\n    " : ",\n    ") + candidate_json(findings.answer.candidates[i]);
  JsonObject json;
  json.add("stack", findings.command.expression).add("spectrum", *findings.command.spectrum_file);
  json.add_json("quantities", "[" + quantities + "]").add("rows", measured.rows.size());
  json.add_json("angles_deg", angles_json(findings)).add("angles_from", angles_from(findings));
  json.add_json("unknowns", "[" + unknowns + "]").add("noise", findings.answer.noise);
  json.add("noise_from", noise_is_stated(findings) ? "statement" : "residuals");
  if (!noise_is_stated(findings)) json.add("least_noise", findings.answer.least_noise);
  json.add("widening", findings.answer.widening);
  json.add("verdict", is_determined(findings) ? verdict_word(findings.answer.in_95_percent) : "undetermined");
  json.add("in_95_percent", findings.answer.in_95_percent).add("unlisted_weight", findings.unlisted_weight);
  json.add("candidates_found", findings.answer.candidates.size());
  return json.add_json("candidates", "[" + candidates + "\n  ]").text();
}

std::string spectrum_findings_csv(const SpectrumFindings& findings) {
  std::string text;
  for (std::size_t j = 0; j < findings.film.names.size(); ++j) {
    const std::string suffix = j == 0 ? "" : "_" + std::to_string(j + 1);
    text += "thickness_nm" + suffix + ",standard_error_nm" + suffix + ",half_95_nm" + suffix + ",";
  }
  text += "rms,weight,scale\n";
  for (const std::size_t i : findings.listed) {
    const desk::SpectrumCandidate& c = findings.answer.candidates[i];
    for (std::size_t j = 0; j < c.thickness_nm.size(); ++j) {
      text += format_exact(c.thickness_nm[j]) + ",";
      for (const std::optional<double> error : {c.standard_error_nm[j], c.half_95_nm[j]})
        text += (error ? format_exact(*error) : "") + ",";
    }
    text += format_exact(c.rms) + "," + format_exact(c.weight) + "," + format_exact(c.scale) + "\n";
  }
  return text;
}

}  // namespace shabon::app
