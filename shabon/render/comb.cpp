#include "shabon/render/comb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shabon::render {

namespace {

using Lanes = std::array<double, lane_count>;

// Solves M x = b for a symmetric positive definite M by Cholesky; `ridge` keeps lamps that are combinations of others,
// or black, from dividing by zero.
std::vector<double> solve_symmetric(std::vector<std::vector<double>> m, std::vector<double> b) {
  const std::size_t n = b.size();
  double trace = 0;
  for (std::size_t i = 0; i < n; ++i) trace += m[i][i];
  const double ridge = std::max(1e-13 * trace, std::numeric_limits<double>::min());
  for (std::size_t i = 0; i < n; ++i) m[i][i] += ridge;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
    m[j][j] = std::sqrt(std::max(m[j][j], ridge));
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
      m[i][j] /= m[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= m[i][k] * b[k];
    b[i] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= m[k][i] * b[k];
    b[i] /= m[i][i];
  }
  return b;
}

double exact_sum(const color::Spectrum& lamp, std::span<const double, color::spectrum_size> response) {
  double sum = 0;
  for (std::size_t i = 0; i < lamp.size(); ++i) sum += lamp[i] * response[i];
  return sum;
}

// The smallest change of the weights after which every lamp comes out exactly, spread evenly over the lanes: a change
// in proportion to the weights would leave a bias three times as large in the mean over all combs, and one in
// proportion to a lamp's lines more than that.
void correct(Lanes& weight, const Lanes& width_nm, const std::vector<Lanes>& lamp_lanes,
             const std::vector<double>& exact) {
  const std::size_t n = lamp_lanes.size();
  std::vector<std::vector<double>> normal(n, std::vector<double>(n));
  std::vector<double> missing(n);
  for (std::size_t a = 0; a < n; ++a) {
    missing[a] = exact[a];
    for (int i = 0; i < lane_count; ++i) missing[a] -= lamp_lanes[a][i] * weight[i];
    for (std::size_t b = 0; b < n; ++b)
      for (int i = 0; i < lane_count; ++i)
        normal[a][b] += lamp_lanes[a][i] * width_nm[i] * width_nm[i] * lamp_lanes[b][i];
  }
  const std::vector<double> factor = solve_symmetric(normal, missing);
  for (int i = 0; i < lane_count; ++i)
    for (std::size_t a = 0; a < n; ++a) weight[i] += width_nm[i] * width_nm[i] * lamp_lanes[a][i] * factor[a];
}

// Each of the 471 table values stands for one nanometre, so the sum covers 359.5 to 830.5 nm.
constexpr double range_nm = double(color::spectrum_size);
constexpr double start_nm = color::first_nm - 0.5;

// How far the evenly spaced combs are off for a lamp, at worst, in X, Y or Z, whose own Y is 1.
double worst_error(const color::Spectrum& lamp, const color::Observer& observer) {
  const std::array responses{observer.x, observer.y, observer.z};
  const double luminance = exact_sum(lamp, observer.y);
  double worst = 0;
  for (const auto& response : responses) {
    const double exact = exact_sum(lamp, response);
    for (int shift = 0; shift < comb_count; ++shift) {
      double sum = 0;
      for (int i = 0; i < lane_count; ++i) {
        const double nm = start_nm + (i + (shift + 0.5) / comb_count) * range_nm / lane_count;
        sum += at_wavelength(lamp, nm) * at_wavelength(response, nm) * range_nm / lane_count;
      }
      worst = std::max(worst, std::abs(sum - exact));
    }
  }
  return luminance > 0 ? worst / luminance : 0;
}

// The density by which wavelengths are placed, per nm: even, unless a lamp has lines, which most combs would miss; then
// most of it follows the lamps.
class Placement {
 public:
  Placement(const color::Observer& observer, std::span<const color::Spectrum> lamps) {
    is_even_ = std::none_of(lamps.begin(), lamps.end(), [&](const color::Spectrum& lamp) {
      return worst_error(lamp, observer) > error_with_lines;
    });
    if (is_even_) return;
    density_.fill((1 - share_of_lamps) / range_nm);
    for (const color::Spectrum& lamp : lamps) {
      const double sum = std::accumulate(lamp.begin(), lamp.end(), 0.0) * double(lamps.size());
      for (std::size_t i = 0; i < density_.size() && sum > 0; ++i) density_[i] += share_of_lamps * lamp[i] / sum;
    }
    below_[0] = 0.5 * density_.front();
    for (std::size_t i = 1; i < below_.size(); ++i) below_[i] = below_[i - 1] + 0.5 * (density_[i - 1] + density_[i]);
    total_ = below_.back() + 0.5 * density_.back();
  }

  // The wavelength that has the share `u`, 0..1, of the density below it.
  double wavelength_nm(double u) const {
    if (is_even_) return start_nm + u * range_nm;
    const double wanted = u * total_;
    const auto above = std::upper_bound(below_.begin(), below_.end(), wanted);
    if (above == below_.begin()) return start_nm + wanted / density_.front();
    const auto left = static_cast<std::size_t>(above - below_.begin()) - 1;
    const double rest = wanted - below_[left], low = density_[left];
    const double slope = left + 1 < density_.size() ? density_[left + 1] - low : 0;
    // rest = low s + slope s^2 / 2
    return color::first_nm + double(left) + 2 * rest / (low + std::sqrt(std::max(0.0, low * low + 2 * slope * rest)));
  }

  // How many nm a lane at the wavelength stands for.
  double width_nm(double wavelength_nm) const {
    if (is_even_) return range_nm / lane_count;
    return total_ / (lane_count * at_wavelength(density_, wavelength_nm));
  }

 private:
  // Both measured: the CIE's daylights, A and E miss 0.04 at most, LEDs up to 0.2, fluorescent lamps more than 1; and
  // with 0.8 the colours of films come out best.
  static constexpr double error_with_lines = 0.1, share_of_lamps = 0.8;

  bool is_even_ = true;
  color::Spectrum density_{}, below_{};  // `below_`: the integral up to each whole nanometre
  double total_ = 1;
};

}  // namespace

double at_wavelength(std::span<const double, color::spectrum_size> spectrum, double wavelength_nm) {
  const double position = std::clamp(wavelength_nm - color::first_nm, 0.0, double(color::spectrum_size - 1));
  const int left = std::min(static_cast<int>(position), color::spectrum_size - 2);
  const double share = position - left;
  return spectrum[static_cast<std::size_t>(left)] * (1 - share) + spectrum[static_cast<std::size_t>(left + 1)] * share;
}

std::vector<Comb> wavelength_combs(const color::Observer& observer, std::span<const color::Spectrum> lamps) {
  const Placement placement(observer, lamps);
  lamps = lamps.first(std::min<std::size_t>(lamps.size(), most_exact_lamps));
  const std::array responses{observer.x, observer.y, observer.z};
  std::vector<Comb> combs(comb_count);
  for (int shift = 0; shift < comb_count; ++shift) {
    Comb& comb = combs[static_cast<std::size_t>(shift)];
    Lanes width_nm;
    for (int i = 0; i < lane_count; ++i) {
      comb.wavelength_nm[i] = placement.wavelength_nm((i + (shift + 0.5) / comb_count) / lane_count);
      width_nm[i] = placement.width_nm(comb.wavelength_nm[i]);
      for (std::size_t c = 0; c < 3; ++c)
        comb.weight[c][i] = width_nm[i] * at_wavelength(responses[c], comb.wavelength_nm[i]);
    }
    comb.plain_weight = comb.weight;
    std::vector<Lanes> lamp_lanes(lamps.size());
    for (std::size_t a = 0; a < lamps.size(); ++a)
      for (int i = 0; i < lane_count; ++i) lamp_lanes[a][i] = at_wavelength(lamps[a], comb.wavelength_nm[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<double> exact(lamps.size());
      for (std::size_t a = 0; a < lamps.size(); ++a) exact[a] = exact_sum(lamps[a], responses[c]);
      correct(comb.weight[c], width_nm, lamp_lanes, exact);
      correct(comb.weight[c], width_nm, lamp_lanes, exact);  // again: what the ridge left over
    }
  }
  return combs;
}

}  // namespace shabon::render
