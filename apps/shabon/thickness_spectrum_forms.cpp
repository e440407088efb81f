// What was found for a spectrum as text, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  const bool stated = findings.command.noise && !findings.answer.noise_exceeded;
  return text + fmt::format("noise of a share {} ({})\n\n", format_number(findings.answer.noise, 3),
                            stated ? "stated" : "from the residuals");
}

// Digits that the error leaves, at most four decimals.
std::string with_error(double value, std::optional<double> error) {
  const double digits = error && *error > 0 ? 1 - std::floor(std::log10(*error)) : 2;
  return fmt::format("{:.{}f}", value, static_cast<int>(std::clamp(digits, 0.0, 4.0)));
}

std::string error_text(std::optional<double> error) { return error ? format_number(*error, 2) : "?"; }

std::string table(const SpectrumFindings& findings) {
  const bool scaled = findings.command.ignore_scale;
  std::string text;
  std::vector<std::size_t> widths;
  for (const std::string& name : findings.film.names) {
    widths.push_back(std::max(narrowest, name.size() + 3));
    text += fmt::format("  {:>{}}  {:<8}", name + " nm", widths.back(), "+-");
  }
  text += fmt::format("  {:>10}{}  {:>8}\n", "rms", scaled ? "     scale" : "", "weight");
  for (std::size_t i = 0; i < findings.listed; ++i) {
    const desk::SpectrumCandidate& c = findings.answer.candidates[i];
    for (std::size_t j = 0; j < widths.size(); ++j)
      text += fmt::format("  {:>{}}  {:<8}", with_error(c.thickness_nm[j], c.standard_error_nm[j]), widths[j],
                          error_text(c.standard_error_nm[j]));
    text += fmt::format("  {:>10}", rms_text(c.rms));
    if (scaled) text += fmt::format("  {:>8}", format_number(c.scale, 4));
    const bool at_end = std::find(c.at_end.begin(), c.at_end.end(), true) != c.at_end.end();
    text += fmt::format("  {:>8}{}\n", percent_text(c.weight), at_end ? "  end of the range" : "");
  }
  return text;
}

std::string correlations(const SpectrumFindings& findings) {
  const desk::SpectrumCandidate& best = findings.answer.candidates.front();
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
  const auto& errors = findings.answer.candidates.front().standard_error_nm;
  return std::all_of(errors.begin(), errors.end(),
                     [](const std::optional<double>& error) { return error.has_value(); });
}

std::string json_or_null(std::optional<double> value) { return value ? json_number(*value) : "null"; }

std::string candidate_json(const desk::SpectrumCandidate& c) {
  std::string errors, ends, correlation;
  for (std::size_t j = 0; j < c.thickness_nm.size(); ++j) {
    errors += (j == 0 ? "" : ", ") + json_or_null(c.standard_error_nm[j]);
    ends += std::string(j == 0 ? "" : ", ") + (c.at_end[j] ? "true" : "false");
  }
  for (std::size_t j = 0; j < c.correlation.size(); ++j)
    correlation += (j == 0 ? "" : ", ") + json_numbers(c.correlation[j]);
  JsonObject json;
  json.add("thickness_nm", c.thickness_nm).add_json("standard_error_nm", "[" + errors + "]");
  json.add("rms", c.rms).add("weight", c.weight).add("scale", c.scale).add_json("at_end", "[" + ends + "]");
  return json.add_json("correlation", "[" + correlation + "]").line();
}

}  // namespace

std::string spectrum_findings_text(const SpectrumFindings& findings) {
  std::string text = heading(findings) + table(findings) + "\n" + correlations(findings);
  text += is_determined(findings) ? verdict_sentence(findings.answer.in_95_percent)
                                  : "Undetermined: many thicknesses fit alike, of which one is listed.";
  text += "\n";
  const std::size_t left = findings.answer.candidates.size() - findings.listed;
  if (left > 0)
    text += fmt::format("{} more, of rms {} and above, {} not listed.\n", left,
                        format_number(findings.answer.candidates[findings.listed].rms, 3), left == 1 ? "is" : "are");
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
  for (std::size_t i = 0; i < findings.listed; ++i)
    candidates += (i == 0 ? "\n    " : ",\n    ") + candidate_json(findings.answer.candidates[i]);
  JsonObject json;
  json.add("stack", findings.command.expression).add("spectrum", *findings.command.spectrum_file);
  json.add_json("quantities", "[" + quantities + "]").add("rows", measured.rows.size());
  json.add_json("unknowns", "[" + unknowns + "]").add("noise", findings.answer.noise);
  json.add("noise_from", findings.command.noise && !findings.answer.noise_exceeded ? "statement" : "residuals");
  json.add("widening", findings.answer.widening);
  json.add("verdict", is_determined(findings) ? verdict_word(findings.answer.in_95_percent) : "undetermined");
  json.add("in_95_percent", findings.answer.in_95_percent);
  json.add("candidates_found", findings.answer.candidates.size());
  return json.add_json("candidates", "[" + candidates + "\n  ]").text();
}

std::string spectrum_findings_csv(const SpectrumFindings& findings) {
  std::string text;
  for (std::size_t j = 0; j < findings.film.names.size(); ++j) {
    const std::string suffix = j == 0 ? "" : "_" + std::to_string(j + 1);
    text += "thickness_nm" + suffix + ",standard_error_nm" + suffix + ",";
  }
  text += "rms,weight,scale\n";
  for (std::size_t i = 0; i < findings.listed; ++i) {
    const desk::SpectrumCandidate& c = findings.answer.candidates[i];
    for (std::size_t j = 0; j < c.thickness_nm.size(); ++j) {
      const std::optional<double> error = c.standard_error_nm[j];
      text += format_exact(c.thickness_nm[j]) + "," + (error ? format_exact(*error) : "") + ",";
    }
    text += format_exact(c.rms) + "," + format_exact(c.weight) + "," + format_exact(c.scale) + "\n";
  }
  return text;
}

}  // namespace shabon::app
