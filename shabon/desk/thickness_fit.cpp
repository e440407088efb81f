#include "shabon/desk/thickness_fit.h"

#include <algorithm>
#include <cmath>

namespace shabon::desk {

namespace {

constexpr int most_steps = 80;
constexpr double first_damping = 1e-3, least_damping = 1e-12, most_damping = 1e12, damping_factor = 8;
constexpr double shortest_step_nm = 1e-9;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// A fit on its way.
class Descent {
 public:
  Descent(FilmModel& model, const UnknownFilm& film, const FitTarget& target)
      : model_(model), target_(target), size_(film.unknowns.size()) {
    computed_.resize(model.size());
    slopes_.resize(size_ * model.size());
  }

  double squares_at(const SmallVector& thickness_nm, double& scale) {
    set(thickness_nm);
    model_.shares(computed_);
    return sum_of_squares(target_, computed_, scale);
  }

  // Differences, gradient and curvature. The scale is solved for at every thickness (variable projection, with the
  // simplification of L. Kaufman, BIT 15 (1975) 49-57): what of the slopes a scale could undo does not count.
  void linearise(const SmallVector& thickness_nm, Fit& fit, SmallVector& gradient) {
    set(thickness_nm);
    model_.shares_and_slopes(computed_, slopes_);
    fit.thickness_nm = thickness_nm;
    fit.squares = sum_of_squares(target_, computed_, fit.scale);
    fit.residuals.resize(computed_.size());
    for (std::size_t i = 0; i < computed_.size(); ++i)
      fit.residuals[i] = fit.scale * computed_[i] - target_.measured[i];
    const double power = dot(computed_, computed_);
    for (std::size_t j = 0; j < size_; ++j) {
      const std::span<double> slope = slopes(j);
      const double share = target_.free_scale && power > 0 ? dot(computed_, slope) / power : 0;
      for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = fit.scale * (slope[i] - share * computed_[i]);
      gradient[j] = dot(slope, fit.residuals);
      for (std::size_t k = 0; k <= j; ++k) fit.curvature[j][k] = fit.curvature[k][j] = dot(slope, slopes(k));
    }
  }

 private:
  std::span<double> slopes(std::size_t j) { return std::span(slopes_).subspan(j * model_.size(), model_.size()); }
  void set(const SmallVector& thickness_nm) {
    for (std::size_t j = 0; j < size_; ++j) model_.set_thickness(j, thickness_nm[j]);
  }

  FilmModel& model_;
  const FitTarget& target_;
  std::size_t size_;
  std::vector<double> computed_, slopes_;
};

// The damped step from the fit, cut to the ranges; an unknown that the gradient pushes out of its range stays.
SmallVector next_thickness(const Fit& fit, SmallVector gradient, double damping, const UnknownFilm& film,
                           const SmallVector& longest_step_nm) {
  const std::size_t size = film.unknowns.size();
  SmallMatrix damped = fit.curvature;
  for (std::size_t j = 0; j < size; ++j) {
    const bool at_low = fit.thickness_nm[j] <= film.unknowns[j].low_nm && gradient[j] >= 0;
    const bool at_high = fit.thickness_nm[j] >= film.unknowns[j].high_nm && gradient[j] <= 0;
    if (at_low || at_high || !(damped[j][j] > 0)) {
      for (std::size_t k = 0; k < size; ++k) damped[j][k] = damped[k][j] = 0;
      damped[j][j] = 1, gradient[j] = 0;
    } else {
      damped[j][j] *= 1 + damping;
    }
  }
  SmallVector next = fit.thickness_nm;
  const std::optional<SmallMatrix> lower = cholesky(damped, size);
  if (!lower) return next;
  const SmallVector step = solve(*lower, gradient, size);
  double shorten = 1;
  for (std::size_t j = 0; j < size; ++j)
    shorten = std::min(shorten, longest_step_nm[j] / std::max(std::abs(step[j]), shortest_step_nm));
  for (std::size_t j = 0; j < size; ++j)
    next[j] = std::clamp(next[j] - shorten * step[j], film.unknowns[j].low_nm, film.unknowns[j].high_nm);
  return next;
}

double distance(const SmallVector& a, const SmallVector& b, std::size_t size) {
  double most = 0;
  for (std::size_t j = 0; j < size; ++j) most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}

}  // namespace

double sum_of_squares(const FitTarget& target, std::span<const double> computed, double& scale) {
  scale = 1;
  if (target.free_scale) {
    const double power = dot(computed, computed);
    scale = power > 0 ? std::max(0.0, dot(computed, target.measured) / power) : 1;
  }
  double sum = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const double difference = scale * computed[i] - target.measured[i];
    sum += difference * difference;
  }
  return sum;
}

Fit fitted(FilmModel& model, const UnknownFilm& film, const FitTarget& target, const SmallVector& start,
           const SmallVector& longest_step_nm) {
  const std::size_t size = film.unknowns.size();
  Descent descent(model, film, target);
  Fit fit;
  SmallVector gradient{};
  descent.linearise(start, fit, gradient);
  double damping = first_damping;
  for (int step = 0; step < most_steps && damping < most_damping; ++step) {
    const SmallVector next = next_thickness(fit, gradient, damping, film, longest_step_nm);
    const double moved = distance(next, fit.thickness_nm, size);
    if (moved == 0 && cholesky(fit.curvature, size)) break;
    double scale = 1;
    if (moved > 0 && descent.squares_at(next, scale) < fit.squares) {
      descent.linearise(next, fit, gradient);
      damping = std::max(damping / damping_factor, least_damping);
    } else {
      damping *= damping_factor;
    }
    if (moved < shortest_step_nm) break;
  }
  return fit;
}

}  // namespace shabon::desk
