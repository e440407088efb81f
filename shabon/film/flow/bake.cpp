#include "shabon/film/flow/bake.h"

#include <cmath>
#include <numbers>

#include "shabon/film/flow/locate.h"

namespace shabon::film {

FlowBake::FlowBake(const FilmFlow& flow, std::span<const math::Vec3d> directions) {
  const auto grid = sphere_grid(flow.desc().level);
  std::size_t from = 0;
  points_.reserve(directions.size());
  for (const math::Vec3d& direction : directions) {
    const Place place = locate(*grid, direction, from);
    Point point{};
    for (std::size_t i = 0; i < 3; ++i) {
      point.cell[i] = static_cast<int>(place.cell[i]);
      point.weight[i] = static_cast<float>(place.weight[i]);
    }
    from = static_cast<std::size_t>(place.cell[0]);
    points_.push_back(point);
  }
}

std::vector<math::Vec3d> latitude_longitude_directions(int width, int height) {
  constexpr double pi = std::numbers::pi;
  std::vector<math::Vec3d> directions;
  directions.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const double polar = (row + 0.5) * pi / height;
    for (int column = 0; column < width; ++column) {
      const double azimuth = ((column + 0.5) / width - 0.5) * 2 * pi;
      directions.push_back(
          {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)});
    }
  }
  return directions;
}

void FlowBake::sample(std::span<const double> values, double scale, std::span<float> out) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto& [cell, weight] = points_[i];
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += static_cast<double>(weight[k]) * values[static_cast<std::size_t>(cell[k])];
    out[i] = static_cast<float>(sum * scale);
  }
}

}  // namespace shabon::film
