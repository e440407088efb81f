#include "shabon/desk/thickness_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace shabon::desk {

namespace {

constexpr double one_deviation = 0.682689492137;  // of a normal distribution
constexpr double wide_share = 0.95;

// Places on each side of the likeliest noise, ever closer towards it, and how far they reach in its widths.
constexpr int side_places = 64;
constexpr double reach = 12;

struct Place {
  double log_noise = 0, share = 0;
};

// The probability of a fit as a function of the noise, less what is common to all fits.
class Likelihood {
 public:
  Likelihood(const Fit& fit, const UnknownFilm& film, const FitTarget& target, const NoiseRange& noise)
      : fit_(fit),
        film_(film),
        alike_(noise.widening * noise.widening),
        usual_(noise.usual),
        freedom_(static_cast<double>(target.measured.size()) / alike_ - (target.free_scale ? 1 : 0)) {}

  double logarithm(double log_noise) const {
    const double variance = alike_ * std::exp(2 * log_noise);
    SmallMatrix information = fit_.curvature;
    for (std::size_t j = 0; j < size(); ++j) {
      for (std::size_t k = 0; k < size(); ++k) information[j][k] /= variance;
      // The uniform prior has the variance range^2/12; it keeps what the spectrum leaves open within the range.
      const double range_nm = film_.unknowns[j].high_nm - film_.unknowns[j].low_nm;
      information[j][j] += 12 / (range_nm * range_nm);
    }
    const std::optional<SmallMatrix> lower = cholesky(information, size());
    const double prior = -std::log1p(std::pow(usual_ / std::exp(log_noise), 2));
    return prior - freedom_ * log_noise - fit_.squares / (2 * variance) -
           (lower ? log_determinant(*lower, size()) / 2 : 0);
  }

  // Degrees of freedom that the thicknesses leave.
  double left() const { return std::max(freedom_ - static_cast<double>(size()), 1.0); }
  double likeliest() const { return std::log(std::max(fit_.squares / (alike_ * left()), 1e-300)) / 2; }
  std::size_t size() const { return film_.unknowns.size(); }

 private:
  const Fit& fit_;
  const UnknownFilm& film_;
  double alike_, usual_, freedom_;
};

std::vector<double> places_of(const Likelihood& likelihood, const NoiseRange& noise) {
  const double low = std::log(noise.least), high = std::log(noise.most);
  const double centre = std::clamp(likelihood.likeliest(), low, high);
  const double far = reach / std::sqrt(2 * likelihood.left());
  std::vector<double> places;
  for (int i = -side_places; i <= side_places; ++i)
    places.push_back(std::clamp(centre + far * std::pow(static_cast<double>(i) / side_places, 3), low, high));
  return places;
}

// The shares of the noises, and the logarithm of the integral over them: trapezia.
std::vector<Place> shares_of(const Likelihood& likelihood, const NoiseRange& noise, double& log_sum) {
  if (!(noise.most > noise.least)) {
    log_sum = likelihood.logarithm(std::log(noise.least));
    return {{std::log(noise.least), 1}};
  }
  const std::vector<double> at = places_of(likelihood, noise);
  std::vector<Place> places;
  double most = -std::numeric_limits<double>::max(), sum = 0;
  for (const double log_noise : at) {
    places.push_back({log_noise, likelihood.logarithm(log_noise)});
    most = std::max(most, places.back().share);
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double width = (at[std::min(i + 1, at.size() - 1)] - at[i == 0 ? 0 : i - 1]) / 2;
    sum += places[i].share = std::exp(places[i].share - most) * width;
  }
  for (Place& place : places) place.share /= sum;
  log_sum = most + std::log(sum / std::log(noise.most / noise.least));
  return places;
}

// Half the width about the fit that holds a share of the probability; `error` is the standard error for a noise of 1.
double half_width(const std::vector<Place>& places, double error, double share) {
  double low = 0, high = 0;
  for (const Place& place : places) high = std::max(high, 8 * error * std::exp(place.log_noise));
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double half = (low + high) / 2;
    double held = 0;
    for (const Place& place : places)
      if (place.share > 1e-9)
        held += place.share * std::erf(half / (error * std::exp(place.log_noise)) / std::numbers::sqrt2);
    (held < share ? low : high) = half;
  }
  return high;
}

}  // namespace

WeighedFit weighed(const Fit& fit, const UnknownFilm& film, const FitTarget& target, const NoiseRange& noise) {
  const Likelihood likelihood(fit, film, target, noise);
  WeighedFit result;
  const std::vector<Place> places = shares_of(likelihood, noise, result.log_weight);
  double log_noise = 0;
  for (const Place& place : places) log_noise += place.share * place.log_noise;
  result.noise = noise.most > noise.least ? std::exp(log_noise) : noise.least;
  const std::optional<SmallMatrix> lower = cholesky(fit.curvature, likelihood.size());
  if (!lower) return result;
  result.covariance = inverse(*lower, likelihood.size());
  for (std::size_t j = 0; j < likelihood.size(); ++j) {
    const double error = noise.widening * std::sqrt(result.covariance[j][j]);
    const double half_nm = half_width(places, error, one_deviation);
    if (!(half_nm < (film.unknowns[j].high_nm - film.unknowns[j].low_nm) / std::sqrt(12.0))) continue;
    result.standard_error_nm[j] = half_nm;
    result.half_95_nm[j] = half_width(places, error, wide_share);
  }
  return result;
}

}  // namespace shabon::desk
