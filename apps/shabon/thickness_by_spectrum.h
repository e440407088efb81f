// What `shabon thickness --spectrum` found, and its forms.
#pragma once

#include <string>

#include "thickness.h"

namespace shabon::app {

struct SpectrumFindings {
  explicit SpectrumFindings(const ThicknessCommand& asked) : command(asked) {}

  const ThicknessCommand& command;
  NamedFilm film;
  desk::SpectrumQuery query;
  desk::SpectrumAnswer answer;
  std::size_t listed = 0;  // of the candidates, from the first
};

std::string spectrum_findings_text(const SpectrumFindings& findings);
std::string spectrum_findings_json(const SpectrumFindings& findings);
std::string spectrum_findings_csv(const SpectrumFindings& findings);

}  // namespace shabon::app
