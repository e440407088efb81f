#include "shabon/film/flow/initial.h"

#include <cmath>

#include "shabon/base/random.h"
#include "shabon/base/text.h"
#include "shabon/film/flow/waves.h"

namespace shabon::film {

namespace {

using math::Vec3d;

void scale_to_mean(const Metric& metric, Numbers& cells, double mean) {
  double area = 0;
  for (const double a : metric.area.values()) area += a;
  const double factor = mean * area / integral(metric, cells);
  for (std::size_t c = 0; c < cells.size(); ++c) cells[c] *= factor;
}

// The depth of a direction below the centre, in radii; 0 without gravity.
double depth(const FlowDesc& desc, const Vec3d& from_centre) {
  const double g = math::length(desc.gravity_m_s2);
  return g > 0 ? math::dot(desc.gravity_m_s2, from_centre) / g : 0;
}

Status set_thickness(const Metric& metric, const FlowDesc& desc, const FilmFlow::InitialThickness& given,
                     Numbers& thickness) {
  const RandomWaves noise(hash64(desc.seed, 1), desc.initial.noise_scale_m);
  for (std::size_t c = 0; c < thickness.size(); ++c) {
    const Vec3d& at = metric.grid->centres[c];
    double h = given ? given(at) : 1;
    if (!(h > 0 && h < 1e9))
      return fail(Failure::content, "the initial thickness must be above 0 nm everywhere, got " + format_number(h, 6));
    if (desc.initial.slope > 0) h *= 1 + desc.initial.slope * depth(desc, at);
    if (desc.initial.noise > 0) h *= std::exp(desc.initial.noise * noise.value(at * metric.radius));
    thickness[c] = h;
  }
  return Done{};
}

// Relative to its mean: (95).
double balancing_surfactant(double squeeze, double slope, double depth) {
  return 1 + squeeze * (depth + slope * (depth * depth - 1.0 / 3) / 2);
}

// Uniform, or in balance with gravity: with the thickness, (79), or under one that is straight in height.
void set_surfactant(const Metric& metric, const FlowDesc& desc, FilmState& state) {
  const double g = math::length(desc.gravity_m_s2), slope = desc.initial.slope;
  const bool balanced = desc.initial.equilibrium && g > 0;
  for (std::size_t c = 0; c < state.surfactant.size(); ++c) {
    const Vec3d& at = metric.grid->centres[c];
    double here = 1;
    if (balanced && slope > 0) {
      here = balancing_surfactant(squeeze(desc), slope, depth(desc, at));
    } else if (balanced) {
      here = std::exp(squeeze(desc) * math::dot(desc.gravity_m_s2, at) / g);
      state.thickness[c] *= here;
    }
    state.surfactant[c] = here;
  }
}

}  // namespace

double squeeze(const FlowDesc& desc) {
  return desc.density_kg_m3 * math::length(desc.gravity_m_s2) * desc.radius_m * desc.mean_thickness_nm * 1e-9 /
         desc.elasticity_n_m;
}

double most_balanced_squeeze(double slope) { return -1 / (balancing_surfactant(1, slope, -1) - 1); }

FilmState empty_state(const Metric& metric) {
  FilmState state;
  state.thickness = state.surfactant = state.surfactant_last = metric.grid->cell_numbers();
  state.along = state.push = metric.grid->edge_numbers();
  return state;
}

Result<FilmState> initial_state(const Metric& metric, const FlowDesc& desc, const FilmFlow::InitialThickness& given) {
  FilmState state = empty_state(metric);
  if (const Status set = set_thickness(metric, desc, given, state.thickness); !set) return set.errors();
  set_surfactant(metric, desc, state);
  scale_to_mean(metric, state.thickness, desc.mean_thickness_nm * 1e-9);
  scale_to_mean(metric, state.surfactant, 1);
  state.surfactant_last = state.surfactant;
  state.surfactant_at_start = integral(metric, state.surfactant);
  if (desc.initial.swirl_m_s > 0) {
    const RandomWaves waves(hash64(desc.seed, 2), desc.initial.swirl_scale_m);
    Numbers stream = metric.grid->triangle_numbers();
    for (std::size_t t = 0; t < stream.size(); ++t)
      stream[t] = desc.initial.swirl_m_s * waves.stream(metric.grid->corners[t] * metric.radius);
    from_stream(metric, stream, state.along);
  }
  return state;
}

}  // namespace shabon::film
