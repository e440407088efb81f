// From a colour to the thickness of a film: every thickness in a range that comes near it, and how sure that is (48).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/color/gamut.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/lab.h"
#include "shabon/color/matrix3.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/thickness_model.h"
#include "shabon/desk/thickness_scan.h"

namespace shabon::desk {

// The difference that is just noticeable, in CIEDE2000, for surfaces seen side by side. Source: M. Mahy, L. Van
// Eycken, A. Oosterlinck, "Evaluation of uniform color spaces developed after the adoption of CIELAB and CIELUV", Color
// Res. Appl. 19 (1994) 105-121, who found 2.3 for the difference of CIELAB.
inline constexpr double noticeable_difference = 2.3;

// A colour that the film had, seen from one side at one angle. All of a query are of one film under one lamp.
struct SeenColor {
  color::Xyz xyz;  // the perfect reflector has Y = 1
  optics::Incidence incidence = {};
  Side side = Side::reflected;
  // How a colour of the film became the one that was told: through this matrix (44), and through a mapping into sRGB.
  std::optional<color::Matrix3> adaptation = {};
  std::optional<color::GamutMapping> shown_by = {};
  std::optional<color::Xyz> white = {};  // of Lab; otherwise the lamp
};

struct ColorQuery {
  UnknownFilm film;  // one unknown
  std::vector<SeenColor> seen;
  color::Illuminant lamp = color::illuminants().front();
  const color::Observer* observer = &color::observer_1931();

  double uncertainty = 1;         // standard deviation of a colour in each direction, in CIEDE2000
  bool ignore_lightness = false;  // colours of unknown exposure: the film's are brought to the same Y
};

struct ColorCandidate {
  double thickness_nm = 0;
  bool at_end = false;              // of the range
  double difference = 0;            // CIEDE2000; of several colours the root mean square
  std::vector<double> differences;  // of each
  std::vector<color::Xyz> xyz;      // of the film, as each is seen
  std::vector<double> exposure;     // what brings that to the Y told; 1 unless lightness is ignored
  std::optional<double> order;      // path difference 2 Re(n cos) thickness / 550 nm of the first colour; an incoherent
                                    // layer has none
  double weight = 0;                // share of the probability, 0..1 (48)
  double interval_low_nm = 0, interval_high_nm = 0;  // 95 % of that

  // Where the colour does not tell the thickness: any of the stretch is as good (scanned_minima()).
  std::optional<Stretch> level = {};
  bool opaque = false;  // because most of it lets next to nothing through: its middle passes less than 1 %, once; tied
                        // layers count one by one
};

struct ColorAnswer {
  std::vector<ColorCandidate> candidates;  // local minima of the difference, the smallest first; at least one
  std::size_t in_95_percent = 0;           // how many it takes to hold 95 % of the weight
  double step_nm = 0;                      // of the scan

  // Whether any is as near as a difference that is noticed, or as three times the uncertainty.
  bool found = false;
  double near = noticeable_difference;  // that limit
};

// Errors: not exactly one unknown or a range that is none, no colour, colours that are not finite or (with
// ignore_lightness) black, an uncertainty that is not positive, a range of more than most_scan_steps.
Result<ColorAnswer> thickness_from_color(const ColorQuery& query);

inline constexpr double most_scan_steps = 200'000;

}  // namespace shabon::desk
