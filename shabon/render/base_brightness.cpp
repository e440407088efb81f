#include "shabon/render/base_brightness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::render {

namespace {

constexpr double pi = std::numbers::pi;

math::Vec3d direction_of(double u, double v) {
  const double azimuth = 2 * pi * (u - 0.5), polar = pi * v;
  return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

BaseBrightness grid_of(int width, int height) {
  return {width, height, std::vector<double>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)), 0};
}

// Any light, by looks at four points of each cell.
template <class Light>
BaseBrightness looked_at(const Light& light, const std::vector<double>& channel_y) {
  BaseBrightness grid = grid_of(512, 256);
  std::vector<double> coefficients(channel_y.size());
  const auto at = [&](double u, double v) {
    std::fill(coefficients.begin(), coefficients.end(), 0.0);
    light.add(direction_of(u, v), coefficients.data());
    double y = 0;
    for (std::size_t k = 0; k < channel_y.size(); ++k) y += coefficients[k] * channel_y[k];
    return std::max(0.0, y);
  };
  auto cell = grid.brightness.begin();
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column, ++cell)
      for (const double du : {0.1, 0.9})
        for (const double dv : {0.1, 0.9}) *cell += at((column + du) / grid.width, (row + dv) / grid.height) / 4;
  return grid;
}

// The texels that a run of cells sees, with the mean of each texel's share: of bilinear hats, one texel to each side.
struct Footprint {
  int first = 0;
  std::vector<double> weights;
};

// The integral of the hat function max(0, 1 - |x|) from far left.
double hat_integral(double x) {
  const double t = std::clamp(x, -1.0, 1.0);
  return t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2;
}

// Cell i of `cells`, moved by `shift` cells, over a row of texels.
Footprint footprint(int i, int cells, int texels, double shift) {
  const double per_cell = double(texels) / cells, low = (i + shift) * per_cell, high = low + per_cell;
  Footprint result;
  result.first = static_cast<int>(std::floor(low - 0.5));
  const int last = static_cast<int>(std::ceil(high - 0.5));
  for (int texel = result.first; texel <= last; ++texel) {
    const double centre = texel + 0.5;
    result.weights.push_back((hat_integral(high - centre) - hat_integral(low - centre)) / per_cell);
  }
  return result;
}

// A picture by the exact means of its bilinear values over the cells (in u and v).
BaseBrightness looked_at(const scene::ImageLight& light, const std::vector<double>& channel_y) {
  const scene::EnvironmentPicture& picture = *light.picture;
  // Two cells a texel follow its slopes.
  BaseBrightness grid = grid_of(std::clamp(2 * picture.width, 64, 2048), std::clamp(2 * picture.height, 32, 1024));
  const auto channel = [&](int c) {
    return light.scale * channel_y[static_cast<std::size_t>(light.first_channel + c)];
  };
  const double red = channel(0), green = channel(1), blue = channel(2);
  std::vector<Footprint> columns;
  for (int column = 0; column < grid.width; ++column)
    columns.push_back(footprint(column, grid.width, picture.width, -light.rotation_turns * grid.width));
  // Each row of texels once, spread over the cells across, then added to the rows of cells that it touches.
  std::vector<double> across(static_cast<std::size_t>(grid.width)), bright(static_cast<std::size_t>(picture.width));
  int row_in_hand = -1;
  const auto take_row = [&](int row) {
    if (row == row_in_hand) return;
    row_in_hand = row;
    for (int x = 0; x < picture.width; ++x) {
      const float* texel = picture.texel(x, row);
      bright[static_cast<std::size_t>(x)] = texel[0] * red + texel[1] * green + texel[2] * blue;
    }
    for (std::size_t column = 0; column < across.size(); ++column) {
      int x = columns[column].first % picture.width;
      if (x < 0) x += picture.width;
      double sum = 0;
      for (const double weight : columns[column].weights) {
        sum += weight * bright[static_cast<std::size_t>(x)];
        if (++x == picture.width) x = 0;
      }
      across[column] = sum;
    }
  };
  for (int row = 0; row < grid.height; ++row) {
    const Footprint rows = footprint(row, grid.height, picture.height, 0);
    double* cells = grid.brightness.data() + static_cast<std::size_t>(row) * across.size();
    for (std::size_t i = 0; i < rows.weights.size(); ++i) {
      if (rows.weights[i] == 0) continue;
      take_row(std::clamp(rows.first + static_cast<int>(i), 0, picture.height - 1));
      for (std::size_t column = 0; column < across.size(); ++column)
        cells[column] += rows.weights[i] * std::max(0.0, across[column]);
    }
  }
  return grid;
}

}  // namespace

double cell_solid_angle(int width, int height, int row) {
  return 2 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
}

BaseBrightness base_brightness(const scene::Environment& environment, const std::vector<double>& channel_y) {
  BaseBrightness grid = std::visit([&](const auto& light) { return looked_at(light, channel_y); }, environment.base);
  for (int row = 0; row < grid.height; ++row) {
    double sum = 0;
    const double* cells = grid.brightness.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
    for (int column = 0; column < grid.width; ++column) sum += cells[column];
    grid.irradiance += sum * cell_solid_angle(grid.width, grid.height, row);
  }
  // A little everywhere: what lies between the points looked at is found too.
  const double floor = 0.02 * grid.irradiance / (4 * pi);
  for (double& value : grid.brightness) value += floor;
  return grid;
}

}  // namespace shabon::render
