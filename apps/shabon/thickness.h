// What `shabon thickness` asks and prints: a film with unknown thicknesses, and a colour or a spectrum of it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/color/adaptation.h"
#include "shabon/desk/thickness_color.h"
#include "shabon/desk/thickness_spectrum.h"

namespace shabon::app {

struct ThicknessCommand {
  std::string expression;
  double low_nm = 0, high_nm = 2000;  // of every `?`
  std::vector<std::string> colors;
  std::optional<std::string> spectrum_file;
  std::vector<double> incidence_deg;
  std::size_t format = 0;
  long long most = 10;  // rows

  // Of colours.
  bool transmitted = false, ignore_lightness = false;
  std::string lamp = "D65";
  std::size_t observer = 0;
  std::optional<color::Adaptation> adaptation;
  std::optional<std::size_t> mapping;
  std::optional<double> uncertainty;

  // Of spectra.
  std::vector<desk::Quantity> columns;
  bool percent = false, ignore_scale = false;
  std::optional<double> noise;
};

enum class ThicknessFormat { text, json, csv };

// The film of the command and the name of each unknown: its medium, and where that is not enough also its layer.
struct NamedFilm {
  desk::UnknownFilm film;
  std::vector<std::string> names;
};

// Errors: those of the expression; Failure::usage when nothing in it is unknown.
Result<NamedFilm> read_unknown_film(const ThicknessCommand& command);

// Asks, reports what there is to say on standard error, and gives what to print.
Result<std::string> thickness_by_color(const ThicknessCommand& command, ThicknessFormat format);
Result<std::string> thickness_by_spectrum(const ThicknessCommand& command, ThicknessFormat format);

// Which of a list to print: the heaviest first, or in its own order, as long as `wanted` says so of an index; at least
// three and at most `most`. Nothing that weighs is left behind for something lighter.
template <class Candidates, class Wanted>
std::vector<std::size_t> chosen(const Candidates& candidates, bool by_weight, long long most, const Wanted& wanted) {
  constexpr std::size_t fewest = 3;
  std::vector<std::size_t> all(candidates.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  if (by_weight)
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t a, std::size_t b) { return candidates[a].weight > candidates[b].weight; });
  std::size_t count = 0;
  while (count < all.size() && (count < fewest || wanted(all[count]))) ++count;
  all.resize(std::min(count, static_cast<std::size_t>(most)));
  return all;
}

// What the others weigh: 1 less the listed.
template <class Candidates>
double weight_beside(const Candidates& candidates, const std::vector<std::size_t>& listed) {
  double rest = 1;
  for (const std::size_t i : listed) rest -= candidates[i].weight;
  constexpr double rounding = 1e-12;
  return rest > rounding ? rest : 0;
}

// Shares of the probability below which a line is left out, and below which nothing is said of all that are.
inline constexpr double least_weight_listed = 5e-3, least_weight_told = 1e-3;

// "One thickness holds 95 % of the probability." and the like, and its word in JSON: one, several or none.
std::string verdict_sentence(std::size_t in_95_percent);
std::string_view verdict_word(std::size_t in_95_percent);

// A length without an exponent: "100000".
std::string nm_text(double nm);

// "62.1 %"; "< 0.1 %" and "> 99.9 %" at the ends.
std::string percent_text(double share);

}  // namespace shabon::app
