#include "thickness_by_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shabon/api/spectrum_file.h"
#include "shabon/base/text.h"
#include "shabon/desk/film_spectrum.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr double widening_worth_telling = 1.2, most_search_fringes = 0.25, most_fringes_between_rows = 0.5;
constexpr double least_explained = 0.5;
constexpr std::size_t enough_freedom = 4;  // values beside the unknowns, for the noise to be told from residuals

// The share of the spectrum's variation that the film explains; 1 where there is none to explain.
double explained(const SpectrumFindings& findings) {
  double sum = 0, squares = 0, count = 0;
  for (const desk::MeasuredRow& row : findings.query.measured.rows)
    for (const double share : row.shares) sum += share, squares += share * share, ++count;
  const double variation = squares / count - sum / count * (sum / count);
  const double rms = findings.answer.candidates.front().rms;  // the least
  return variation > 0 ? 1 - rms * rms / variation : 1;
}

void note_search(const SpectrumFindings& findings, Diagnostics& notes) {
  const desk::SpectrumAnswer& answer = findings.answer;
  if (answer.search_step_fringes > most_search_fringes)
    notes.push_back(warning_of(fmt::format(
        "the ranges are too wide to search completely: steps of {:.2f} fringes, {} would be sure; narrow them, as in "
        "'SiO2 100..300nm'",
        answer.search_step_fringes, format_number(most_search_fringes))));
  if (answer.fringes_between_rows > most_fringes_between_rows) {
    double high_nm = 0;
    const desk::UnknownFilm& film = findings.film.film;
    for (std::size_t j = 0; j < film.unknowns.size(); ++j)
      if (desk::has_fringes(film, j)) high_nm = std::max(high_nm, film.unknowns[j].high_nm);
    notes.push_back(warning_of(
        fmt::format("the wavelengths are too far apart to follow the fringes of films above {} nm; thicker ones may be "
                    "mistaken for thinner ones",
                    format_number(high_nm * most_fringes_between_rows / answer.fringes_between_rows, 3))));
  }
}

void note_fit(const SpectrumFindings& findings, Diagnostics& notes) {
  const desk::SpectrumAnswer& answer = findings.answer;
  const desk::SpectrumCandidate& best = most_probable(findings);
  if (answer.noise_exceeded)
    notes.push_back(warning_of(fmt::format(
        "the residuals are {:.1f} times the stated noise: the film is not quite as described; errors and weights "
        "take the residuals for the noise",
        answer.noise / *findings.command.noise)));
  if (answer.widening > widening_worth_telling)
    notes.push_back(warning_of(
        fmt::format("neighbouring residuals are alike, so the film is not quite as described; errors are {:.1f} times "
                    "those of random noise",
                    answer.widening)));
  const std::size_t values = findings.query.measured.rows.size() * findings.query.measured.quantities.size();
  const std::size_t unknowns = best.thickness_nm.size() + (findings.command.ignore_scale ? 1 : 0);
  if (!findings.command.noise && values < unknowns + enough_freedom)
    notes.push_back(
        warning_of(fmt::format("{} values for {} unknown{} hardly tell how large their noise is; --noise states it",
                               values, unknowns, unknowns == 1 ? "" : "s")));
  const double share = explained(findings);
  if (share < least_explained)
    notes.push_back(
        warning_of(fmt::format("the best film explains {:.0f} % of the spectrum's variation: is it this "
                               "film?",
                               100 * std::max(share, 0.0))));
  for (std::size_t j = 0; j < best.thickness_nm.size(); ++j) {
    const std::string& name = findings.film.names[j];
    if (!best.standard_error_nm[j])
      notes.push_back(warning_of(name + ": this spectrum does not determine its thickness"));
    else if (best.at_end[j])
      notes.push_back(warning_of(name + ": the best thickness is the end of the range; it may go on beyond it"));
  }
}

void choose_listed(SpectrumFindings& findings) {
  const auto& candidates = findings.answer.candidates;
  findings.listed = chosen(candidates, true, findings.command.most,
                           [&](std::size_t i) { return candidates[i].weight >= least_weight_listed; });
  findings.unlisted_weight = weight_beside(candidates, findings.listed);
}

// More than noise and calibration explain; a common factor may be anything.
void note_shares(const SpectrumFindings& findings, Diagnostics& notes) {
  constexpr double least = -0.05, most = 1.05;
  double low = 0, high = 0;
  for (const desk::MeasuredRow& row : findings.query.measured.rows)
    for (const double share : row.shares) low = std::min(low, share), high = std::max(high, share);
  if (low < least)
    notes.push_back(
        warning_of(fmt::format("a share of {}, below 0: is its baseline subtracted twice?", format_number(low, 4))));
  if (high > most && !findings.command.ignore_scale)
    notes.push_back(warning_of(
        fmt::format("a share of {}, above 1: more light than came in; --ignore-scale leaves the calibration open",
                    format_number(high, 4))));
}

void note_angles(const SpectrumFindings& findings, Diagnostics& notes) {
  const std::string file = printable(*findings.command.spectrum_file, 100);
  const std::vector<double>& told = findings.command.incidence_deg;
  if (findings.query.measured.has_angles && !told.empty())
    notes.push_back(warning_of(file + " has angles of its own; --angle is passed over"));
  if (!findings.query.measured.has_angles && told.empty())
    notes.push_back(warning_of(file + " has no column angle_deg; 0 degrees is assumed (--angle tells another)"));
}

}  // namespace

Result<std::string> thickness_by_spectrum(const ThicknessCommand& command, ThicknessFormat format) {
  Result<NamedFilm> film = read_unknown_film(command);
  if (!film) return film.errors();
  if (film->film.unknowns.size() > desk::most_unknowns)
    return fail(Failure::usage, fmt::format("STACK: expected at most {} unknown thicknesses, got {}",
                                            desk::most_unknowns, film->film.unknowns.size()));
  Result<desk::MeasuredSpectrum> measured = api::read_spectrum_file(
      *command.spectrum_file,
      {command.columns, command.percent, command.incidence_deg.empty() ? 0 : command.incidence_deg.front()});
  if (!measured) return measured.errors();

  SpectrumFindings findings(command);
  findings.film = std::move(*film);
  findings.query = {findings.film.film, std::move(*measured), command.noise, command.ignore_scale};
  std::vector<double> wavelengths_nm;
  for (const desk::MeasuredRow& row : findings.query.measured.rows) wavelengths_nm.push_back(row.wavelength_nm);
  Diagnostics notes = desk::range_warnings(findings.film.film.stack, wavelengths_nm);
  Result<desk::SpectrumAnswer> answer = desk::thickness_from_spectrum(findings.query);
  if (!answer) return answer.errors();
  findings.answer = std::move(*answer);
  choose_listed(findings);
  note_angles(findings, notes);
  note_shares(findings, notes);
  note_search(findings, notes);
  note_fit(findings, notes);
  report(notes);
  switch (format) {
    case ThicknessFormat::json:
      return spectrum_findings_json(findings);
    case ThicknessFormat::csv:
      return spectrum_findings_csv(findings);
    case ThicknessFormat::text:
      break;
  }
  return spectrum_findings_text(findings);
}

const desk::SpectrumCandidate& most_probable(const SpectrumFindings& findings) {
  return findings.answer.candidates[findings.listed.front()];
}

}  // namespace shabon::app
