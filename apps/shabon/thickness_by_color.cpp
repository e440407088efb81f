#include "thickness_by_color.h"

#include <fmt/format.h>

#include <algorithm>

#include "lamp_input.h"
#include "shabon/color/adaptation.h"
#include "shabon/desk/film_spectrum.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

// The angle of each colour: one for all, or one for each.
std::vector<double> angles_of(const ThicknessCommand& command) {
  std::vector<double> angles = command.incidence_deg.empty() ? std::vector<double>{0} : command.incidence_deg;
  if (angles.size() == 1) angles.resize(command.colors.size(), angles.front());
  return angles;
}

// How the film's colour became the one that was told.
Status describe(desk::SeenColor& seen, const ToldColor& told, const ThicknessCommand& command, color::Xyz lamp_white) {
  if (command.adaptation) {
    const std::optional<color::Xyz> white = color::white_of(told.space);
    if (!white)
      return fail(Failure::usage, fmt::format("--adaptation: expected a colour space with a white of its own, got {}",
                                              color::name_of(told.space)));
    seen.adaptation = color::adaptation_matrix(lamp_white, *white, *command.adaptation);
    seen.white = white;
  }
  if (command.mapping)
    seen.shown_by = color::gamut_mappings()[*command.mapping].mapping;
  else if (told.is_bytes)
    seen.shown_by = color::GamutMapping::clip;
  return Done{};
}

Status read_colors(ColorFindings& findings) {
  const ThicknessCommand& command = findings.command;
  const color::Xyz lamp_white = color::white_point(findings.query.lamp, *findings.query.observer);
  for (std::size_t i = 0; i < command.colors.size(); ++i) {
    Result<ToldColor> told = told_color(command.colors[i], lamp_white);
    if (!told) return told.errors();
    if (command.ignore_lightness && !(told->xyz.y > 0))
      return fail(Failure::usage, "--ignore-lightness: expected a colour with a luminance above 0, got " + told->text);
    desk::SeenColor seen{told->xyz, optics::incidence_from(Degrees(findings.incidence_deg[i])),
                         command.transmitted ? desk::Side::transmitted : desk::Side::reflected};
    if (const Status described = describe(seen, *told, command, lamp_white); !described) return described;
    findings.query.seen.push_back(seen);
    findings.told.push_back(std::move(*told));
  }
  return Done{};
}

// Where a colour was rounded to bytes more coarsely than it is said to be known.
void note_rounding(const ColorFindings& findings, Diagnostics& notes) {
  for (std::size_t i = 0; i < findings.told.size(); ++i) {
    const color::Xyz white =
        findings.query.seen[i].white.value_or(color::white_point(findings.query.lamp, *findings.query.observer));
    const double rounding = rounding_difference(findings.told[i], white);
    if (rounding > findings.query.uncertainty)
      notes.push_back(warning_of(fmt::format(
          "{}: rounding to bytes alone leaves a difference of {:.2f} open, more than the stated uncertainty",
          findings.told[i].text, rounding)));
  }
}

void add_notes(const ColorFindings& findings, Diagnostics& notes) {
  const desk::ColorCandidate& best = findings.answer.candidates.front();
  for (const ToldColor& told : findings.told)
    if (told.is_bytes && told.at_the_end)
      notes.push_back(
          warning_of(fmt::format("{}: 0 or 255 may stand for anything beyond; the film's colours are {}", told.text,
                                 findings.command.mapping ? "mapped into sRGB alike" : "clipped alike")));
  if (!findings.answer.found && !findings.command.ignore_lightness) {
    double told = 0, reached = 0;
    for (std::size_t i = 0; i < findings.told.size(); ++i)
      told = std::max(told, findings.told[i].xyz.y), reached = std::max(reached, best.xyz[i].y);
    constexpr double much_brighter = 1.5;
    if (told > much_brighter * reached)
      notes.push_back(
          warning_of(fmt::format("the colour has Y = {:.3f}, the nearest film {:.3f}; for a photograph or "
                                 "any picture of unknown exposure use --ignore-lightness",
                                 told, reached)));
  }
  const desk::ColorCandidate& heaviest = findings.answer.candidates[findings.listed.front()];
  if (findings.answer.found && heaviest.level)
    notes.push_back(warning_of(level_sentence(heaviest) + ": the colour does not tell which"));
  else if (findings.answer.found && best.at_end)
    notes.push_back(warning_of("the nearest thickness is the end of the range; it may go on beyond it"));
}

void choose_listed(ColorFindings& findings) {
  const auto& candidates = findings.answer.candidates;
  const bool found = findings.answer.found;
  findings.listed = chosen(candidates, found, findings.command.most, [&](std::size_t i) {
    return candidates[i].difference <= findings.answer.near || (found && candidates[i].weight >= least_weight_listed);
  });
  findings.unlisted_weight = weight_beside(candidates, findings.listed);
}

}  // namespace

Result<std::string> thickness_by_color(const ThicknessCommand& command, ThicknessFormat format) {
  Result<NamedFilm> film = read_unknown_film(command);
  if (!film) return film.errors();
  if (film->film.unknowns.size() > 1)
    return fail(Failure::usage, fmt::format("--color: expected one unknown thickness in STACK, got {}; several need "
                                            "--spectrum",
                                            film->film.unknowns.size()));
  Result<color::Illuminant> lamp = read_lamp(command.lamp);
  if (!lamp) return lamp.errors();

  ColorFindings findings(command);
  findings.film = std::move(*film);
  findings.incidence_deg = angles_of(command);
  findings.lamp = lamp->name;
  findings.observer = color::observers()[command.observer].name;
  findings.query.film = findings.film.film;
  findings.query.lamp = std::move(*lamp);
  findings.query.observer = &color::observers()[command.observer];
  findings.query.ignore_lightness = command.ignore_lightness;
  if (const Status read = read_colors(findings); !read) return read.errors();
  Diagnostics notes =
      desk::range_warnings(findings.film.film.stack, std::vector<double>{color::first_nm, color::last_nm});
  for (Diagnostic& note : power_notes(findings.film.film.stack, command.transmitted)) notes.push_back(std::move(note));
  findings.query.uncertainty = command.uncertainty.value_or(findings.query.uncertainty);
  note_rounding(findings, notes);

  Result<desk::ColorAnswer> answer = desk::thickness_from_color(findings.query);
  if (!answer) return answer.errors();
  findings.answer = std::move(*answer);
  choose_listed(findings);
  add_notes(findings, notes);
  report(notes);
  switch (format) {
    case ThicknessFormat::json:
      return color_findings_json(findings);
    case ThicknessFormat::csv:
      return color_findings_csv(findings);
    case ThicknessFormat::text:
      break;
  }
  return color_findings_text(findings);
}

std::string level_sentence(const desk::ColorCandidate& candidate) {
  return fmt::format("{:.1f} to {:.1f} nm are alike{}", candidate.level->low_nm, candidate.level->high_nm,
                     candidate.opaque ? ", most of them opaque" : "");
}

bool is_determined(const ColorFindings& findings) {
  const desk::Unknown& unknown = findings.film.film.unknowns.front();
  double open = 0;
  for (const desk::ColorCandidate& candidate : findings.answer.candidates) {
    const double left_nm = candidate.interval_high_nm - candidate.interval_low_nm;
    if (left_nm > (unknown.high_nm - unknown.low_nm) / 2) open += candidate.weight;
  }
  return open < 1 - desk::credible_share;
}

color::EncodedRgb shown_color(const ColorFindings& findings, const desk::ColorCandidate& candidate, std::size_t color) {
  const desk::SeenColor& seen = findings.query.seen[color];
  const double exposure = candidate.exposure[color];
  color::Vector3 v{candidate.xyz[color].x * exposure, candidate.xyz[color].y * exposure,
                   candidate.xyz[color].z * exposure};
  if (seen.adaptation) v = color::multiply(*seen.adaptation, v);
  const color::LinearRgb linear = color::xyz_to_linear_srgb({v[0], v[1], v[2]});
  return color::encode_srgb(color::map_to_srgb_gamut(linear, seen.shown_by.value_or(color::GamutMapping::clip)));
}

}  // namespace shabon::app
