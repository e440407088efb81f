#include "shabon/render/kernel/scattering/probe_walks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shabon/base/parallel.h"
#include "shabon/base/random.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// The error is taken from the spread of so many means with seeds of their own.
constexpr std::size_t batches = 16;

// Walks that differ by no more than this differ by the rounding of float, not by chance.
constexpr double rounding = 1e-5;

std::size_t walks_of_batch(const ProbeOptions& options) {
  return std::max<std::size_t>(1, (options.samples + batches - 1) / batches);
}

// Groups of wavelengths as combs; the last one is filled up with its last wavelength.
std::vector<Comb> combs_of(std::span<const double> wavelengths_nm) {
  std::vector<Comb> combs((wavelengths_nm.size() + lane_count - 1) / lane_count);
  for (std::size_t c = 0; c < combs.size(); ++c)
    for (std::size_t i = 0; i < lane_count; ++i)
      combs[c].wavelength_nm[i] = wavelengths_nm[std::min(c * lane_count + i, wavelengths_nm.size() - 1)];
  return combs;
}

struct Sums {
  double radiance[lane_count] = {}, squares[lane_count] = {};
  Lanes least{std::numeric_limits<float>::max()}, most{0.0f};  // of single walks
  std::uint64_t events = 0, cut = 0, dropped = 0;
};

// The means of the batches of one comb.
Sums sums_of(const ScatteringTables& tables, WalkStart start, std::size_t comb, const ProbeOptions& options) {
  Walk walk(tables);
  Sums sums;
  std::vector<double> direct;
  start.comb = comb;
  const std::size_t each = walks_of_batch(options);
  for (std::size_t batch = 0; batch < batches; ++batch) {
    double mean[lane_count] = {};
    start.seed = static_cast<std::uint32_t>(hash64(options.seed, batch));
    for (std::size_t sample = 0; sample < each; ++sample) {
      start.sample = static_cast<std::uint32_t>(sample);
      const WalkLight light = walk.follow(start, direct);
      Lanes radiance = light.radiance + light.alone;
      if (light.direct)
        for (std::size_t k = 0; k < direct.size(); ++k)
          radiance += tables.films.channels[comb * direct.size() + k] *
                      Lanes(static_cast<float>(direct[k]) * light.direct_carried);
      sums.least = min(sums.least, radiance), sums.most = max(sums.most, radiance);
      for (int i = 0; i < lane_count; ++i) mean[i] += double(radiance[i]) / static_cast<double>(each);
    }
    for (int i = 0; i < lane_count; ++i) sums.radiance[i] += mean[i], sums.squares[i] += mean[i] * mean[i];
  }
  sums.events = walk.counts().events, sums.cut = walk.counts().cut_paths, sums.dropped = walk.counts().dropped;
  return sums;
}

}  // namespace

ProbeResult probe_walks(const scene::Scene& scene, const WalkStart& start, std::span<const double> wavelengths_nm,
                        const ProbeOptions& options) {
  ProbeResult result;
  if (wavelengths_nm.empty()) return result;
  const std::vector<Comb> combs = combs_of(wavelengths_nm);
  const ScatteringTables tables(scene, combs);
  WalkStart here = start;  // wherever the ray begins
  if (!here.space) here.space = space_at(tables, start.origin, start.direction);
  std::vector<Sums> sums(combs.size());
  parallel_for(combs.size(), 0, [&](std::size_t c) { sums[c] = sums_of(tables, here, c, options); });
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    const Sums& of = sums[i / lane_count];
    const double mean = of.radiance[i % lane_count] / batches;
    const double spread = std::max(0.0, of.squares[i % lane_count] / batches - mean * mean);
    result.radiance.push_back(mean);
    // Batches of an even spread may agree by their evenness: then one walk more or less is what they cannot tell.
    const double range = double(of.most[i % lane_count]) - double(of.least[i % lane_count]);
    const double one_walk = range / static_cast<double>(batches * walks_of_batch(options));
    const double error = std::sqrt(spread / (batches - 1) + one_walk * one_walk);
    result.standard_error.push_back(range > rounding * std::abs(mean) ? error : 0);
  }
  for (const Sums& of : sums)
    result.film_events += of.events, result.cut_branches += of.cut, result.dropped_samples += of.dropped;
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
