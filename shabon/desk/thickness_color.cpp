#include "shabon/desk/thickness_color.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/desk/fringes.h"
#include "shabon/desk/retardation.h"
#include "shabon/desk/sweep.h"
#include "shabon/desk/thickness_check.h"
#include "shabon/desk/thickness_scan.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::desk {

namespace {

// The observers see next to nothing below; shorter waves make no minimum of their own.
constexpr double shortest_seen_nm = 400;
constexpr double steps_per_fringe = 128;
constexpr std::size_t most_candidates = 400;
constexpr double deviations_near = 3;

std::vector<ModelRow> visible_rows(optics::Incidence incidence) {
  std::vector<ModelRow> rows;
  for (std::size_t i = 0; i < color::spectrum_size; ++i)
    rows.push_back({static_cast<double>(color::wavelength_nm(i)), incidence});
  return rows;
}

// The colours of several layers of one thickness, which no sweep knows: by 1 nm, or with means over nanometres that
// hold many fringes (17), looked at closely enough for the thickest films of the range.
class TiedColors {
 public:
  TiedColors(const ColorQuery& query, const SeenColor& seen)
      : query_(query), seen_(seen), plain_(model_of(visible_rows(seen.incidence))), fine_(plain_) {
    optics::Stack thickest = at(query.film.unknowns.front().high_nm);
    std::vector<ModelRow> rows;
    for (const ModelRow& row : visible_rows(seen.incidence)) {
      first_.push_back(rows.size());
      const Fringes found = fringes(optics::resolve(thickest, row.wavelength_nm), seen.incidence, row.wavelength_nm);
      for (const double offset_nm : looks_within_nm(found))
        rows.push_back({row.wavelength_nm + offset_nm, seen.incidence});
    }
    first_.push_back(rows.size());
    if (rows.size() > color::spectrum_size) fine_ = model_of(rows);
  }

  std::vector<color::Xyz> colors(const std::vector<double>& thicknesses_nm) const {
    std::vector<color::Xyz> colors(thicknesses_nm.size());
    const std::size_t slices = std::min<std::size_t>(colors.size(), 16);
    parallel_for(slices, 0, [&](std::size_t slice) {
      FilmModel plain = plain_, fine = fine_;
      for (std::size_t i = colors.size() * slice / slices; i < colors.size() * (slice + 1) / slices; ++i) {
        FilmModel& film = is_resolved(thicknesses_nm[i]) ? plain : fine;
        film.set_thickness(0, thicknesses_nm[i]);
        colors[i] = color::reflectance_to_xyz(means(film), query_.lamp, *query_.observer);
      }
    });
    return colors;
  }

 private:
  FilmModel model_of(const std::vector<ModelRow>& rows) const {
    const Quantity quantity[] = {seen_.side == Side::reflected ? Quantity::R : Quantity::T};
    return FilmModel(query_.film, rows, quantity);
  }

  optics::Stack at(double thickness_nm) const {
    optics::Stack stack = query_.film.stack;
    for (const std::size_t layer : query_.film.unknowns.front().layers) stack.layers[layer].thickness_nm = thickness_nm;
    return stack;
  }

  // At the shortest wavelength the fringes are the finest.
  bool is_resolved(double thickness_nm) const {
    const optics::Stack stack = at(thickness_nm);
    return !may_have_fine_fringes(stack) ||
           fringes(optics::resolve(stack, color::first_nm), seen_.incidence, color::first_nm).all_per_nm <=
               most_fringes_per_nm;
  }

  color::Spectrum means(FilmModel& film) const {
    color::Spectrum share{};
    if (film.size() == share.size()) {
      film.shares(share);
      return share;
    }
    std::vector<double> shares(film.size());
    film.shares(shares);
    for (std::size_t i = 0; i < share.size(); ++i) {
      for (std::size_t row = first_[i]; row < first_[i + 1]; ++row) share[i] += shares[row];
      share[i] /= static_cast<double>(first_[i + 1] - first_[i]);
    }
    return share;
  }

  const ColorQuery& query_;
  const SeenColor& seen_;
  FilmModel plain_, fine_;
  std::vector<std::size_t> first_;  // row of each nanometre in fine_, and the end
};

// Of a checked query.
std::vector<color::Xyz> colors_at(const ColorQuery& query, const SeenColor& seen,
                                  const std::vector<double>& thicknesses_nm) {
  const Unknown& unknown = query.film.unknowns.front();
  if (unknown.layers.size() > 1) return TiedColors(query, seen).colors(thicknesses_nm);
  Sweep sweep{query.film.stack, unknown.layers.front(), thicknesses_nm, seen.incidence, seen.side};
  const Result<std::vector<color::Xyz>> colors = swept_colors(sweep, query.lamp, *query.observer);
  return colors ? *colors : std::vector<color::Xyz>(thicknesses_nm.size());
}

// A colour of the film beside the colour that was told.
class Comparison {
 public:
  Comparison(const ColorQuery& query, const SeenColor& seen)
      : seen_(seen),
        ignore_lightness_(query.ignore_lightness),
        white_(seen.white.value_or(color::white_point(query.lamp, *query.observer))),
        told_(color::xyz_to_lab(seen.xyz, white_)) {}

  double exposure(color::Xyz xyz) const {
    const double y = adapted(xyz).y;
    return ignore_lightness_ && y > darkest ? seen_.xyz.y / y : 1;
  }

  double difference(color::Xyz xyz) const {
    const double factor = exposure(xyz);
    color::Xyz shown = adapted({xyz.x * factor, xyz.y * factor, xyz.z * factor});
    if (seen_.shown_by)
      shown = color::linear_srgb_to_xyz(color::map_to_srgb_gamut(color::xyz_to_linear_srgb(shown), *seen_.shown_by));
    return color::ciede2000(color::xyz_to_lab(shown, white_), told_);
  }

 private:
  static constexpr double darkest = 1e-12;  // no exposure makes more of it

  color::Xyz adapted(color::Xyz xyz) const {
    if (!seen_.adaptation) return xyz;
    const color::Vector3 v = color::multiply(*seen_.adaptation, color::Vector3{xyz.x, xyz.y, xyz.z});
    return {v[0], v[1], v[2]};
  }

  const SeenColor& seen_;
  bool ignore_lightness_;
  color::Xyz white_;
  color::Lab told_;
};

Status check(const ColorQuery& query) {
  if (Status status = check_unknowns(query.film, 1); !status) return status;
  const auto refuse = [](const std::string& message) { return fail(Failure::content, message); };
  if (query.seen.empty()) return refuse("expected a colour, got none");
  for (const SeenColor& seen : query.seen) {
    if (!std::isfinite(seen.xyz.x) || !std::isfinite(seen.xyz.y) || !std::isfinite(seen.xyz.z))
      return refuse("expected a finite colour");
    if (query.ignore_lightness && !(seen.xyz.y > 0)) return refuse("black has nothing but its lightness");
  }
  if (!(query.uncertainty > 0 && std::isfinite(query.uncertainty))) return refuse("expected an uncertainty > 0");
  return check_computable(query.film.stack, optics::Interference::airy);
}

double step_nm(const ColorQuery& query) {
  double fringes = 0;
  for (const SeenColor& seen : query.seen) {
    std::vector<ModelRow> rows = visible_rows(seen.incidence);
    std::erase_if(rows, [](const ModelRow& row) { return row.wavelength_nm < shortest_seen_nm; });
    fringes = std::max(fringes, fringes_per_nm(query.film, 0, rows));
  }
  const Unknown& unknown = query.film.unknowns.front();
  return std::min(1 / (steps_per_fringe * fringes), (unknown.high_nm - unknown.low_nm) / steps_per_fringe);
}

// The order of the path difference (6), as the charts mark it.
std::optional<double> order_of(const ColorQuery& query, double thickness_nm) {
  if (!has_fringes(query.film, 0)) return {};
  const optics::Stack& stack = query.film.stack;
  const std::complex<double> n1 = stack.incidence.index(order_retardation_nm);
  const std::complex<double> n =
      stack.layers[query.film.unknowns.front().layers.front()].medium.index(order_retardation_nm);
  const double n_cos = std::abs(optics::normal_index(n1, query.seen.front().incidence, n).real());
  return 2 * n_cos * thickness_nm / order_retardation_nm;
}

// Whether most of the stretch lets next to nothing through.
bool is_opaque(const ColorQuery& query, const Stretch& level) {
  constexpr double most_passing = 0.01;
  const Unknown& unknown = query.film.unknowns.front();
  if (level.high_nm < unknown.high_nm) return false;
  const double middle_nm = (level.low_nm + level.high_nm) / 2;
  const optics::Medium& medium = query.film.stack.layers[unknown.layers.front()].medium;
  for (const SeenColor& seen : query.seen) {
    color::Spectrum share{};
    for (std::size_t i = 0; i < color::spectrum_size; ++i) {
      const auto nm = static_cast<double>(color::wavelength_nm(i));
      const double k_c =
          optics::normal_index(query.film.stack.incidence.index(nm), seen.incidence, medium.index(nm)).imag();
      share[i] = std::exp(-4 * std::numbers::pi * std::abs(k_c) * middle_nm / nm);
    }
    if (color::reflectance_to_xyz(share, query.lamp, *query.observer).y > most_passing) return false;
  }
  return true;
}

ColorCandidate candidate_of(const ColorQuery& query, const std::vector<Comparison>& comparisons,
                            const ScanMinimum& minimum) {
  ColorCandidate candidate;
  candidate.thickness_nm = minimum.thickness_nm;
  candidate.at_end = minimum.at_end;
  candidate.weight = minimum.weight;
  candidate.interval_low_nm = minimum.interval_low_nm, candidate.interval_high_nm = minimum.interval_high_nm;
  candidate.level = minimum.level;
  candidate.opaque = minimum.level && is_opaque(query, *minimum.level);
  candidate.order = order_of(query, minimum.thickness_nm);
  double squares = 0;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const color::Xyz xyz = colors_at(query, query.seen[i], {minimum.thickness_nm}).front();
    candidate.xyz.push_back(xyz);
    candidate.exposure.push_back(comparisons[i].exposure(xyz));
    candidate.differences.push_back(comparisons[i].difference(xyz));
    squares += candidate.differences.back() * candidate.differences.back();
  }
  candidate.difference = std::sqrt(squares / static_cast<double>(comparisons.size()));
  return candidate;
}

}  // namespace

Result<ColorAnswer> thickness_from_color(const ColorQuery& query) {
  if (const Status status = check(query); !status) return status.errors();
  const Unknown& unknown = query.film.unknowns.front();
  ColorAnswer answer;
  answer.step_nm = step_nm(query);
  if (!((unknown.high_nm - unknown.low_nm) / answer.step_nm <= most_scan_steps))
    return fail(Failure::content, "expected a range of at most " +
                                      format_number(std::floor(most_scan_steps * answer.step_nm), 3) + " nm for the " +
                                      (has_fringes(query.film, 0) ? "fringes" : "absorption") + " of this film, got " +
                                      format_number(unknown.high_nm - unknown.low_nm) + " nm");

  std::vector<Comparison> comparisons;
  for (const SeenColor& seen : query.seen) comparisons.emplace_back(query, seen);
  const Misfit misfit = [&](const std::vector<double>& thicknesses_nm) {
    std::vector<double> sums(thicknesses_nm.size(), 0);
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
      const std::vector<color::Xyz> colors = colors_at(query, query.seen[i], thicknesses_nm);
      for (std::size_t t = 0; t < sums.size(); ++t) {
        const double deviations = comparisons[i].difference(colors[t]) / query.uncertainty;
        sums[t] += deviations * deviations;
      }
    }
    return sums;
  };
  std::vector<double> weights;
  for (const ScanMinimum& minimum :
       scanned_minima(misfit, {unknown.low_nm, unknown.high_nm, answer.step_nm}, most_candidates)) {
    answer.candidates.push_back(candidate_of(query, comparisons, minimum));
    weights.push_back(minimum.weight);
  }
  answer.in_95_percent = count_credible(weights);
  answer.near = std::max(noticeable_difference, deviations_near * query.uncertainty);
  answer.found = answer.candidates.front().difference <= answer.near;
  return answer;
}

}  // namespace shabon::desk
