// What the kinds of `shabon chart` share: their options, and what each of them makes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "chart_range.h"
#include "shabon/base/result.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/gamut.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/io/svg.h"
#include "shabon/optics/interference.h"

namespace shabon::app {

enum class ChartExposure { each, one, stops };

// Where an option was not given its default depends on the kind.
struct ChartOptions {
  std::optional<std::string> expression;
  std::size_t interference_index = 0;
  std::optional<long long> layer;  // counted from 1
  std::optional<ChartRange> thickness_nm;
  ChartAngles angles_deg;
  std::optional<std::size_t> side_index;  // of chart_sides()
  bool curves = false;
  std::optional<ChartRange> retardation_nm;
  std::vector<double> birefringences;
  std::optional<std::string> model;  // of thickness, as below `thickness` in a scene file
  std::vector<double> times_s = {0};
  color::Illuminant lamp;
  std::size_t observer_index = 0, gamut_index = 0;
  std::optional<color::Adaptation> adaptation;  // of what is drawn, from the lamp to the white of sRGB
  ChartExposure exposure = ChartExposure::each;
  double exposure_ev = 0;  // with ChartExposure::stops
  bool wants_drawing = true, wants_table = true;

  optics::Interference interference() const { return optics::interference_models[interference_index].value; }
  const color::Observer& observer() const { return color::observers()[observer_index]; }
  color::GamutMapping gamut() const { return color::gamut_mappings()[gamut_index].mapping; }
};

// The sides of a film that a chart shows.
struct ChartSide {
  std::string_view name;
  std::vector<desk::Side> sides;
};

std::vector<ChartSide> chart_sides();
std::string_view name_of(desk::Side side);

// A drawing and the same numbers as a table.
struct MadeChart {
  io::Chart drawing;
  std::string csv;
  Diagnostics warnings;
};

Result<MadeChart> make_newton_chart(const ChartOptions& options);
Result<MadeChart> make_angle_chart(const ChartOptions& options);
Result<MadeChart> make_michel_levy_chart(const ChartOptions& options);
Result<MadeChart> make_profile_chart(const ChartOptions& options);

// The film of the paper of 1989, where no model is given.
inline constexpr const char* default_profile_model = "{linear: {top_nm: 150, bottom_nm: 900}}";

// The pictures that a model of thickness names.
std::vector<std::filesystem::path> profile_files(const ChartOptions& options);

struct ChartKind {
  std::string_view name;
  std::string_view summary;
  Result<MadeChart> (*make)(const ChartOptions&);
  ChartExposure exposure = ChartExposure::each;  // unless one is asked for
};

// The closed set.
inline constexpr ChartKind chart_kinds[] = {
    {"newton", "colour over the thickness of a film, reflected and transmitted", make_newton_chart},
    {"angle", "colour over thickness and angle", make_angle_chart},
    {"michel-levy", "colours of birefringent minerals between crossed polarisers", make_michel_levy_chart},
    // One factor, so that strips at several times tell how bright each film is.
    {"profile", "thickness and colour from the top of a bubble to its bottom", make_profile_chart, ChartExposure::one},
};

}  // namespace shabon::app
