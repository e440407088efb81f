// What `shabon thickness --color` found, and its forms.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "thickness.h"
#include "thickness_target.h"

namespace shabon::app {

struct ColorFindings {
  explicit ColorFindings(const ThicknessCommand& asked) : command(asked) {}

  const ThicknessCommand& command;
  NamedFilm film;
  std::vector<ToldColor> told;
  std::vector<double> incidence_deg;  // of each colour
  std::string lamp;
  std::string_view observer;
  desk::ColorQuery query;
  desk::ColorAnswer answer;
  std::vector<std::size_t> listed =
      {};                      // of the candidates; the most probable first, or where nothing fits the nearest
  double unlisted_weight = 0;  // of all others
};

std::string color_findings_text(const ColorFindings& findings);
std::string color_findings_json(const ColorFindings& findings);
std::string color_findings_csv(const ColorFindings& findings);

// "61.2 to 500.0 nm are alike, as the layer is opaque", of a candidate that is level.
std::string level_sentence(const desk::ColorCandidate& candidate);

// Whether intervals of less than half the range hold 95 % of the probability.
bool is_determined(const ColorFindings& findings);

// A film's colour as sRGB shows it, brought to the exposure that the candidate has; clipped.
color::EncodedRgb shown_color(const ColorFindings& findings, const desk::ColorCandidate& candidate, std::size_t color);

}  // namespace shabon::app
