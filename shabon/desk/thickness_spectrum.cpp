#include "shabon/desk/thickness_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/thickness_check.h"
#include "shabon/desk/thickness_fit.h"
#include "shabon/desk/thickness_grid.h"
#include "shabon/desk/thickness_noise.h"
#include "shabon/desk/thickness_scan.h"

namespace shabon::desk {

namespace {

constexpr std::size_t most_starts = 200;
constexpr std::size_t fewest_search_rows = 48;
constexpr double search_rows_per_fringe = 3;
constexpr double longest_step_fringes = 0.25;
constexpr double rounding_noise = 1e-10;      // what the model itself is good for
constexpr double same_thickness_nm = 1e-3;    // two fits within it are one,
constexpr double same_squared_errors = 1e-2;  // or within a tenth of the standard error
// Residuals larger than the noise by five of their own standard deviations are not noise.
constexpr double noise_deviations = 5;

struct Problem {
  UnknownFilm film;
  std::vector<ModelRow> rows;
  std::vector<Quantity> quantities;
  std::vector<double> measured;
  SmallVector fringes{};  // per nm
  bool free_scale = false;

  std::size_t size() const { return film.unknowns.size(); }
  FitTarget target() const { return {measured, free_scale}; }
  double freedom() const { return static_cast<double>(measured.size() - size() - (free_scale ? 1 : 0)); }
};

Status check(const SpectrumQuery& query) {
  if (Status status = check_unknowns(query.film, most_unknowns); !status) return status;
  const MeasuredSpectrum& measured = query.measured;
  const auto refuse = [](const std::string& message) { return fail(Failure::content, message); };
  if (measured.quantities.empty()) return refuse("expected at least one measured quantity, got none");
  for (const MeasuredRow& row : measured.rows) {
    if (row.shares.size() != measured.quantities.size())
      return refuse("expected a share for every quantity in each row");
    if (!(row.wavelength_nm > 0 && std::isfinite(row.wavelength_nm)))
      return refuse("expected wavelengths > 0 nm, got " + format_number(row.wavelength_nm));
    if (!(row.incidence_deg >= 0 && row.incidence_deg <= 90))
      return refuse("expected angles of 0..90 degrees, got " + format_number(row.incidence_deg));
    for (const double share : row.shares)
      if (!std::isfinite(share)) return refuse("expected finite shares");
  }
  const std::size_t values = measured.rows.size() * measured.quantities.size();
  const std::size_t unknowns = query.film.unknowns.size() + (query.ignore_scale ? 1 : 0);
  if (values <= unknowns)
    return refuse("expected more measured values than unknowns (" + std::to_string(unknowns) + "), got " +
                  std::to_string(values));
  if (query.noise && !(*query.noise > 0 && std::isfinite(*query.noise))) return refuse("expected a noise > 0");
  return check_computable(query.film.stack, optics::Interference::airy);
}

Problem problem_of(const SpectrumQuery& query) {
  Problem problem{query.film, {}, query.measured.quantities, {}, {}, query.ignore_scale};
  std::vector<MeasuredRow> rows = query.measured.rows;
  std::stable_sort(rows.begin(), rows.end(), [](const MeasuredRow& a, const MeasuredRow& b) {
    return a.incidence_deg != b.incidence_deg ? a.incidence_deg < b.incidence_deg : a.wavelength_nm < b.wavelength_nm;
  });
  for (const MeasuredRow& row : rows) {
    problem.rows.push_back({row.wavelength_nm, optics::incidence_from(Degrees(row.incidence_deg))});
    problem.measured.insert(problem.measured.end(), row.shares.begin(), row.shares.end());
  }
  for (std::size_t j = 0; j < problem.size(); ++j) problem.fringes[j] = fringes_per_nm(problem.film, j, problem.rows);
  return problem;
}

// How much the fringes of an unknown at the upper end of its range differ between two rows.
double fringes_between(const Problem& problem, std::size_t unknown, std::size_t row, std::size_t other) {
  if (!has_fringes(problem.film, unknown)) return 0;
  const std::span<const ModelRow> rows = problem.rows;
  const double here = fringes_per_nm(problem.film, unknown, rows.subspan(row, 1));
  const double there = fringes_per_nm(problem.film, unknown, rows.subspan(other, 1));
  return std::abs(here - there) * problem.film.unknowns[unknown].high_nm;
}

// Several unknowns are searched with fewer rows, enough for the fringes of the thickest films.
Problem search_problem(const Problem& problem) {
  if (problem.size() == 1) return problem;
  double fringes = 0;
  for (std::size_t j = 0; j < problem.size(); ++j) fringes += fringes_between(problem, j, 0, problem.rows.size() - 1);
  const double wanted = std::max(static_cast<double>(fewest_search_rows), search_rows_per_fringe * fringes);
  if (static_cast<double>(problem.rows.size()) <= wanted) return problem;
  Problem fewer = problem;
  fewer.rows.clear(), fewer.measured.clear();
  const auto count = static_cast<std::size_t>(wanted), columns = problem.quantities.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i * (problem.rows.size() - 1) / (count - 1);
    fewer.rows.push_back(problem.rows[row]);
    for (std::size_t c = 0; c < columns; ++c) fewer.measured.push_back(problem.measured[row * columns + c]);
  }
  return fewer;
}

std::vector<Fit> all_fits(const Problem& problem, SpectrumAnswer& answer) {
  const Problem search = search_problem(problem);
  const FilmModel coarse(search.film, search.rows, search.quantities);
  const GridMinima minima = grid_minima(coarse, search.film, search.target(), problem.fringes, most_starts);
  answer.search_step_fringes = minima.step_fringes;
  SmallVector longest_step_nm{};
  for (std::size_t j = 0; j < problem.size(); ++j)
    longest_step_nm[j] = longest_step_fringes / std::max(problem.fringes[j], 1 / optics::largest_thickness_nm);

  const FilmModel model(problem.film, problem.rows, problem.quantities);
  std::vector<Fit> fits(minima.starts.size());
  parallel_for(fits.size(), 0, [&](std::size_t i) {
    FilmModel own = model;
    fits[i] = fitted(own, problem.film, problem.target(), minima.starts[i], longest_step_nm);
  });
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.squares < b.squares; });
  return fits;
}

// The correlation of residuals that follow each other in wavelength, where it is more than chance makes it.
double neighbour_correlation(const Problem& problem, const std::vector<double>& residuals) {
  const std::size_t columns = problem.quantities.size();
  double product = 0, squares = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += residuals[i] * residuals[i];
    if (i >= columns) product += residuals[i] * residuals[i - columns];
  }
  constexpr double most = 0.98;
  const double correlation = squares > 0 ? product / squares : 0;
  return correlation > 2 / std::sqrt(static_cast<double>(residuals.size())) ? std::min(correlation, most) : 0;
}

// What the noise may be: as stated, unless the residuals are larger; or anything that digits and instruments allow.
NoiseRange noise_range(const SpectrumQuery& query, const Problem& problem, const Fit& best, SpectrumAnswer& answer) {
  NoiseRange range;
  if (query.noise) {
    const double freedom = problem.freedom(), variance = best.squares / freedom;
    const double most = 1 + noise_deviations * std::sqrt(2 / freedom);
    answer.noise_exceeded = variance > *query.noise * *query.noise * most;
    range.least = range.most = std::max(*query.noise, rounding_noise);
  } else {
    double unit = 0;
    for (const double value : problem.measured) unit = std::max(unit, std::abs(value));
    range.usual = usual_noise * (problem.free_scale ? unit : 1);
    range.least = std::max({rounding_noise, least_noise * (problem.free_scale ? unit : 1),
                            query.measured.step / std::sqrt(12.0)});  // the deviation of what rounding leaves open
  }
  if (query.noise && !answer.noise_exceeded) return range;
  range.most = std::max(largest_noise, 10 * range.least);
  const double correlation = neighbour_correlation(problem, best.residuals);
  answer.widening = range.widening = std::sqrt((1 + correlation) / (1 - correlation));
  answer.least_noise = range.least;
  return range;
}

double difference_in_errors(const Fit& a, const Fit& b, std::size_t size, double variance) {
  double sum = 0;
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t k = 0; k < size; ++k)
      sum += (a.thickness_nm[j] - b.thickness_nm[j]) * a.curvature[j][k] * (a.thickness_nm[k] - b.thickness_nm[k]);
  return sum / variance;
}

// Fits that ended in the same minimum become one. Sorted by their squares before and after.
std::vector<Fit> distinct(std::vector<Fit> fits, std::size_t size, double variance) {
  std::vector<Fit> kept;
  for (Fit& fit : fits) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Fit& other) {
      double most = 0;
      for (std::size_t j = 0; j < size; ++j)
        most = std::max(most, std::abs(fit.thickness_nm[j] - other.thickness_nm[j]));
      return most < same_thickness_nm || (difference_in_errors(other, fit, size, variance) < same_squared_errors &&
                                          fit.squares - other.squares < same_squared_errors * variance);
    });
    if (!known) kept.push_back(std::move(fit));
  }
  return kept;
}

SpectrumCandidate candidate_of(const Fit& fit, const Problem& problem, const WeighedFit& weighed) {
  const std::size_t size = problem.size();
  SpectrumCandidate candidate;
  candidate.rms = std::sqrt(fit.squares / static_cast<double>(problem.measured.size()));
  candidate.scale = fit.scale;
  bool all_determined = true;
  for (std::size_t j = 0; j < size; ++j) {
    const Unknown& unknown = problem.film.unknowns[j];
    const double at = fit.thickness_nm[j];
    candidate.thickness_nm.push_back(at);
    candidate.standard_error_nm.push_back(weighed.standard_error_nm[j]);
    candidate.half_95_nm.push_back(weighed.half_95_nm[j]);
    candidate.at_end.push_back(at <= unknown.low_nm || at >= unknown.high_nm);
    all_determined = all_determined && weighed.standard_error_nm[j];
  }
  const SmallMatrix& covariance = weighed.covariance;
  for (std::size_t j = 0; all_determined && j < size; ++j) {
    candidate.correlation.emplace_back();
    for (std::size_t k = 0; k < size; ++k)
      candidate.correlation[j].push_back(covariance[j][k] / std::sqrt(covariance[j][j] * covariance[k][k]));
  }
  return candidate;
}

void weigh(const std::vector<Fit>& fits, const Problem& problem, const NoiseRange& noise, SpectrumAnswer& answer) {
  std::vector<double> weights;
  for (const Fit& fit : fits) {
    const WeighedFit result = weighed(fit, problem.film, problem.target(), noise);
    if (answer.candidates.empty()) answer.noise = result.noise;
    answer.candidates.push_back(candidate_of(fit, problem, result));
    weights.push_back(result.log_weight);
  }
  const double most = *std::max_element(weights.begin(), weights.end());
  double sum = 0;
  for (double& weight : weights) sum += weight = std::exp(weight - most);
  for (std::size_t i = 0; i < fits.size(); ++i) answer.candidates[i].weight = weights[i] /= sum;
  answer.in_95_percent = count_credible(weights);
}

double fringes_between_rows(const Problem& problem) {
  double most = 0;
  for (std::size_t i = 1; i < problem.rows.size(); ++i) {
    if (problem.rows[i].incidence.cos_i != problem.rows[i - 1].incidence.cos_i) continue;
    for (std::size_t j = 0; j < problem.size(); ++j) most = std::max(most, fringes_between(problem, j, i - 1, i));
  }
  return most;
}

}  // namespace

Result<SpectrumAnswer> thickness_from_spectrum(const SpectrumQuery& query) {
  if (const Status status = check(query); !status) return status.errors();
  const Problem problem = problem_of(query);
  SpectrumAnswer answer;
  answer.fringes_between_rows = fringes_between_rows(problem);
  std::vector<Fit> fits = all_fits(problem, answer);
  const NoiseRange noise = noise_range(query, problem, fits.front(), answer);
  const double variance = std::max(fits.front().squares / problem.freedom(), noise.least * noise.least);
  fits = distinct(std::move(fits), problem.size(), variance * noise.widening * noise.widening);
  weigh(fits, problem, noise, answer);
  return answer;
}

}  // namespace shabon::desk
