// What `shabon thickness --spectrum` found, and its forms.
#pragma once

#include <string>
#include <vector>

#include "thickness.h"

namespace shabon::app {

struct SpectrumFindings {
  explicit SpectrumFindings(const ThicknessCommand& asked) : command(asked) {}

  const ThicknessCommand& command;
  NamedFilm film;
  desk::SpectrumQuery query;
  desk::SpectrumAnswer answer;
  std::vector<std::size_t> listed = {};  // of the candidates, the most probable first
  double unlisted_weight = 0;            // of all others
};

// The first of the list.
const desk::SpectrumCandidate& most_probable(const SpectrumFindings& findings);

std::string spectrum_findings_text(const SpectrumFindings& findings);
std::string spectrum_findings_json(const SpectrumFindings& findings);
std::string spectrum_findings_csv(const SpectrumFindings& findings);

}  // namespace shabon::app
