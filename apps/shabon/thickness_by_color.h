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
  std::size_t listed = 0;  // of the candidates, from the first
};

std::string color_findings_text(const ColorFindings& findings);
std::string color_findings_json(const ColorFindings& findings);
std::string color_findings_csv(const ColorFindings& findings);

// A film's colour as sRGB shows it, brought to the exposure that the candidate has; clipped.
color::EncodedRgb shown_color(const ColorFindings& findings, const desk::ColorCandidate& candidate, std::size_t color);

}  // namespace shabon::app
