// What `shabon compare` found, and its forms.
#pragma once

#include <string>
#include <vector>

#include "chart_swept.h"
#include "shabon/desk/comparison.h"
#include "shabon/io/svg.h"

namespace shabon::app {

struct CompareReport {
  SweptFilm film;
  desk::Sweep sweep;
  double incidence_deg = 0;
  color::Illuminant lamp;
  const color::Observer* observer = nullptr;
  double brightness = 1;  // of the colours that are compared
  desk::Comparison comparison;
};

// For people: a line for each shortcut with mean, median, 95 %, largest difference and where that is.
std::string compare_text(const CompareReport& report);
// The whole series: the exact colour and the differences, a row for every thickness.
std::string compare_csv(const CompareReport& report);
// Both, as one object.
std::string compare_json(const CompareReport& report);

// The differences as lines over the thickness, below them the colours themselves as strips.
io::Chart compare_chart(const CompareReport& report);

// "reflected at 45 degrees, unpolarised, lamp D65, observer 1931", and the brightness where it is not 1.
std::string compare_conditions(const CompareReport& report);

}  // namespace shabon::app
