// From a measured spectrum to the thicknesses of up to four layers: least squares over the whole range (49)-(51).
#pragma once

#include <optional>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/desk/thickness_model.h"

namespace shabon::desk {

struct MeasuredRow {
  double wavelength_nm = 0;    // in vacuum, > 0
  double incidence_deg = 0;    // 0..90
  std::vector<double> shares;  // one for each quantity, of the incident power; noise may leave 0..1
};

struct MeasuredSpectrum {
  std::vector<Quantity> quantities;
  std::vector<MeasuredRow> rows;  // in any order
  double step = 0;                // of the last digit that the shares were given with; 0 where that is unknown
  bool has_angles = true;         // rows were measured at these angles; otherwise one was assumed
};

struct SpectrumQuery {
  UnknownFilm film;
  MeasuredSpectrum measured;
  std::optional<double> noise = {};  // standard deviation of a share; otherwise unknown, and told by the residuals
  bool ignore_scale = false;         // the shares have one unknown common factor
};

// The least noise of a share that is not stated: few photometers repeat and are calibrated better. With an unknown
// scale it is a share of the largest value.
inline constexpr double least_noise = 1e-4;
// Below this it is thought less likely, unless the residuals show it: most photometers are not better.
inline constexpr double usual_noise = 1e-3;
// The most: no shares of 0..1 scatter more than evenly spread ones.
inline constexpr double largest_noise = 0.3;

// One minimum of the residuals.
struct SpectrumCandidate {
  std::vector<double> thickness_nm;                      // of each unknown
  std::vector<std::optional<double>> standard_error_nm;  // half of what holds 68 %; nothing where not determined
  std::vector<std::optional<double>> half_95_nm;         // of what holds 95 %; more than twice that when values are few
  std::vector<bool> at_end;                              // of its range
  std::vector<std::vector<double>> correlation;          // of the errors; empty where one is not determined
  double rms = 0;                                        // of computed minus measured
  double scale = 1;                                      // measured over computed, where it is free
  double weight = 0;                                     // share of the probability, 0..1 (51)
};

struct SpectrumAnswer {
  std::vector<SpectrumCandidate> candidates;  // every distinct minimum, the smallest rms first; at least one
  std::size_t in_95_percent = 0;              // how many it takes to hold 95 % of the weight
  double noise = 0;                           // standard deviation that the best leaves likely, or as stated
  double least_noise = 0;                     // that was thought possible where it was not stated
  bool noise_exceeded = false;                // the residuals are larger than the stated noise, and replaced it
  double widening = 1;                        // of the errors, as neighbouring residuals are alike
  double fringes_between_rows = 0;            // the most that pass from one wavelength to the next; 0.5 is too many
  double search_step_fringes = 0;             // of the search grid, in fringes; above 0.25 it may have missed minima
};

// Deterministic, whatever the number of threads. Errors: no rows or not more values than unknowns, unknowns or ranges
// that are none, shares that are not finite, wavelengths or angles out of range.
Result<SpectrumAnswer> thickness_from_spectrum(const SpectrumQuery& query);

}  // namespace shabon::desk
