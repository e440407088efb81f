#include "shabon/render/kernel/scattering/coating_table.h"

#include <algorithm>
#include <numbers>

#include "shabon/optics/reference/stack.h"
#include "shabon/render/kernel/scattering/pane_table.h"
#include "shabon/render/microfacet.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

optics::StackRay CoatingTable::ray(bool from_back, double cos, double thickness_nm) const {
  optics::StackRay ray{.cos_i = cos};
  if (thickness_nm >= 0) {
    const std::size_t layer = coating->varied->layer;
    ray.layer = from_back ? back.layers.size() - 1 - layer : layer;
    ray.thickness_nm = thickness_nm;
  }
  return ray;
}

BoundaryPowers CoatingTable::powers(bool from_back, std::size_t comb, double cos, double thickness_nm) const {
  const Lanes half(0.5f);
  const auto m =
      optics::stack_powers<lane_count>(from_back ? back : front, comb * lane_count, ray(from_back, cos, thickness_nm));
  return {half * (m.R_s + m.R_p), half * (m.T_s + m.T_p)};
}

// Gauss and Legendre's rule in the cosine, with the weight 2 cos.
BoundaryPowers CoatingTable::diffuse_means(std::size_t comb, double thickness_nm) const {
  if (!front_means.empty()) return front_means[comb];
  constexpr double nodes[] = {0.03376524289842397, 0.16939530676686776, 0.38069040695840156,
                              0.6193095930415985,  0.8306046932331322,  0.966234757101576};
  constexpr double weights[] = {0.08566224618958525, 0.1803807865240693, 0.23395696728634546,
                                0.23395696728634546, 0.1803807865240693, 0.08566224618958525};
  BoundaryPowers means{Lanes(0.0f), Lanes(0.0f)};
  for (std::size_t k = 0; k < std::size(nodes); ++k) {
    const BoundaryPowers m = powers(false, comb, nodes[k], thickness_nm);
    const Lanes weight(static_cast<float>(2 * nodes[k] * weights[k]));
    means.reflected += m.reflected * weight, means.transmitted += m.transmitted * weight;
  }
  return means;
}

namespace {

// Where a number lies.
struct NumberRange {
  double least, most;
};

NumberRange range_of(const scene::NumberTexture& texture) {
  const auto& raster = texture.picture.raster;
  if (raster == nullptr || raster->values.empty()) return {texture.constant, texture.constant};
  const auto [least, most] = std::minmax_element(raster->values.begin(), raster->values.end());
  return {*least, *most};
}

// Over the directions from a sphere's centre.
NumberRange range_of(const film::ThicknessField& model) {
  constexpr int rows = 33, columns = 16;
  NumberRange range{film::thickness_nm(model, math::Vec3d{0, 1, 0}), 0};
  range.most = range.least;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double y = 1 - 2.0 * i / (rows - 1), across = std::sqrt(std::max(0.0, 1 - y * y));
      const double turn = 2 * std::numbers::pi * j / columns;
      const double nm = film::thickness_nm(model, math::Vec3d{across * std::cos(turn), y, across * std::sin(turn)});
      range.least = std::min(range.least, nm), range.most = std::max(range.most, nm);
    }
  return range;
}

Nodes alpha_nodes(const scene::NumberTexture& roughness) {
  constexpr int most_nodes = 9;
  const NumberRange range = range_of(roughness);
  const double most = std::clamp(range.most, 0.0, 1.0), least = std::clamp(range.least, least_alpha, 1.0);
  if (most < least_alpha) return {};
  return {least, most, most > least ? most_nodes : 1};
}

// `alphas`: tables of both would grow large.
Nodes thickness_nodes(const scene::Coating& coating, int alphas) {
  if (!coating.varied) return {-1, -1, 1};
  constexpr double step_nm = 20;
  const double most_nodes = alphas > 1 ? 8 : 24;
  const NumberRange range =
      std::visit([](const auto& thickness) { return range_of(thickness); }, coating.varied->thickness_nm);
  const double least = std::max(0.0, range.least), most = std::max(least, range.most);
  return {least, most, static_cast<int>(std::min(most_nodes, std::ceil((most - least) / step_nm) + 1))};
}

double mean_ratio(const std::vector<LanesD>& ratios) {
  double sum = 0;
  for (const LanesD& row : ratios)
    for (int i = 0; i < lane_count; ++i) sum += row[i] / lane_count;
  return sum / static_cast<double>(ratios.size());
}

void add_rest(CoatingTable& table, const scene::NumberTexture& roughness, RestGoes rest) {
  RestTable::Side side;
  side.alpha = alpha_nodes(roughness);
  if (rest == RestGoes::nowhere || side.alpha.count == 0) return;
  side.thickness_nm = thickness_nodes(*table.coating, side.alpha.count);
  side.combs = table.index_ratio.size();
  side.refracts = rest == RestGoes::spread && table.bends();
  const auto from = [&](bool back) {
    side.near_over_far = back ? 1 / mean_ratio(table.index_ratio) : mean_ratio(table.index_ratio);
    side.each_near_over_far = table.index_ratio;
    if (back)
      for (LanesD& row : side.each_near_over_far) row = LanesD(1.0) / row;
    side.powers = [&table, back](std::size_t comb, double cos, double nm) { return table.powers(back, comb, cos, nm); };
    return RestTable(side);
  };
  table.front_rest = from(false);
  if (rest == RestGoes::spread) table.back_rest = from(true);
}

}  // namespace

std::unique_ptr<CoatingTable> coating_table(const scene::Coating& coating, const scene::NumberTexture& roughness,
                                            RestGoes rest, const std::vector<Comb>& combs,
                                            const std::function<int(const optics::Medium&)>& space_of) {
  std::vector<double> wavelengths_nm;
  for (const Comb& comb : combs)
    wavelengths_nm.insert(wavelengths_nm.end(), comb.wavelength_nm.begin(), comb.wavelength_nm.end());
  const bool opaque = rest == RestGoes::nowhere;
  optics::Stack stack = coating.stack;
  const int in_front = space_of(stack.incidence), behind = opaque ? 0 : space_of(stack.exit);
  stack.incidence = stack.incidence.without_absorption();
  if (!opaque) stack.exit = stack.exit.without_absorption();
  // Seen from behind an opaque surface is black; its table is never asked.
  const optics::Stack back = opaque ? stack : optics::reversed(stack);
  auto table = std::make_unique<CoatingTable>(
      CoatingTable{optics::StackTable(stack, wavelengths_nm), optics::StackTable(back, wavelengths_nm), &coating});
  table->opaque = opaque, table->space_in_front = in_front, table->space_behind = behind;
  table->one_direction = stack.incidence.is_constant() && stack.exit.is_constant();
  for (const Comb& comb : combs) {
    double ratio[lane_count];
    for (int i = 0; i < lane_count; ++i)
      ratio[i] = stack.incidence.index(comb.wavelength_nm[i]).real() / stack.exit.index(comb.wavelength_nm[i]).real();
    table->index_ratio.push_back(LanesD::load(ratio));
    table->n_behind_squared.push_back(
        math::convert<float>(LanesD(1.0) / (table->index_ratio.back() * table->index_ratio.back())));
  }
  if (!coating.varied) {
    std::vector<BoundaryPowers> means;
    for (std::size_t comb = 0; comb < combs.size(); ++comb) means.push_back(table->diffuse_means(comb, -1));
    table->front_means = std::move(means);
  }
  add_rest(*table, roughness, rest);
  return table;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
