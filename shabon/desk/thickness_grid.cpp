#include "shabon/desk/thickness_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "shabon/base/parallel.h"

namespace shabon::desk {

namespace {

// One unknown is searched more finely than several.
constexpr double steps_per_fringe_of_one = 16, steps_per_fringe_of_several = 8;
// Of all points of the grid, times the values computed at each: a few seconds.
constexpr double most_values = 4e7, most_points = 2e6;

using Index = std::array<std::size_t, most_unknowns>;

struct Grid {
  std::size_t size = 1;      // how many unknowns
  Index counts{1, 1, 1, 1};  // the last one of them counts fastest
  const UnknownFilm& film;

  std::size_t points() const {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{1}, std::multiplies<>());
  }
  Index index(std::size_t point) const {
    Index index{};
    for (std::size_t j = size; j-- > 0; point /= counts[j]) index[j] = point % counts[j];
    return index;
  }
  double thickness_nm(std::size_t j, std::size_t i) const {
    const Unknown& unknown = film.unknowns[j];
    return unknown.low_nm + (unknown.high_nm - unknown.low_nm) * static_cast<double>(i) /
                                static_cast<double>(std::max<std::size_t>(counts[j] - 1, 1));
  }
  double step_nm(std::size_t j) const {
    return (film.unknowns[j].high_nm - film.unknowns[j].low_nm) / static_cast<double>(counts[j] - 1);
  }
};

Grid grid_of(const UnknownFilm& film, const SmallVector& fringes_per_nm, double most) {
  Grid grid{film.unknowns.size(), {1, 1, 1, 1}, film};
  const auto fill = [&](double steps_per_fringe) {
    for (std::size_t j = 0; j < grid.size; ++j) {
      const double range_nm = film.unknowns[j].high_nm - film.unknowns[j].low_nm;
      const double steps = std::ceil(std::min(range_nm * fringes_per_nm[j] * steps_per_fringe, most_points));
      grid.counts[j] = 1 + static_cast<std::size_t>(std::max(steps, 4.0));
    }
    return std::accumulate(grid.counts.begin(), grid.counts.end(), 1.0,
                           [](double product, std::size_t count) { return product * static_cast<double>(count); });
  };
  double steps_per_fringe = grid.size == 1 ? steps_per_fringe_of_one : steps_per_fringe_of_several;
  constexpr double coarser = 0.97;
  while (fill(steps_per_fringe) > most && steps_per_fringe > 1e-3) steps_per_fringe *= coarser;
  return grid;
}

// The first unknown's slices, each by one thread.
std::vector<double> squares_on(const Grid& grid, const FilmModel& model, const FitTarget& target) {
  std::vector<double> squares(grid.points());
  const std::size_t slices = std::min<std::size_t>(grid.points(), 64);
  parallel_for(slices, 0, [&](std::size_t slice) {
    FilmModel film = model;
    std::vector<double> computed(model.size());
    Index last;
    last.fill(squares.size());
    const std::size_t end = squares.size() * (slice + 1) / slices;
    for (std::size_t point = squares.size() * slice / slices; point < end; ++point) {
      const Index index = grid.index(point);
      for (std::size_t j = 0; j < grid.size; ++j)
        if (index[j] != last[j]) film.set_thickness(j, grid.thickness_nm(j, index[j]));
      last = index;
      film.shares(computed);
      double scale = 1;
      squares[point] = sum_of_squares(target, computed, scale);
    }
  });
  return squares;
}

// Not above its neighbours along any unknown.
bool is_minimum(const Grid& grid, const std::vector<double>& squares, std::size_t point) {
  const Index index = grid.index(point);
  std::size_t stride = 1;
  for (std::size_t j = grid.size; j-- > 0; stride *= grid.counts[j]) {
    if (index[j] > 0 && squares[point - stride] < squares[point]) return false;
    if (index[j] + 1 < grid.counts[j] && squares[point + stride] < squares[point]) return false;
  }
  return true;
}

}  // namespace

GridMinima grid_minima(const FilmModel& model, const UnknownFilm& film, const FitTarget& target,
                       const SmallVector& fringes_per_nm, std::size_t most_starts) {
  const double most = std::min(most_points, most_values / static_cast<double>(model.size()));
  const Grid grid = grid_of(film, fringes_per_nm, most);
  const std::vector<double> squares = squares_on(grid, model, target);
  std::vector<std::size_t> minima;
  for (std::size_t point = 0; point < squares.size(); ++point)
    if (is_minimum(grid, squares, point)) minima.push_back(point);
  std::stable_sort(minima.begin(), minima.end(), [&](std::size_t a, std::size_t b) { return squares[a] < squares[b]; });
  if (minima.size() > most_starts) minima.resize(most_starts);

  GridMinima found;
  for (const std::size_t point : minima) {
    const Index index = grid.index(point);
    SmallVector start{};
    for (std::size_t j = 0; j < grid.size; ++j) start[j] = grid.thickness_nm(j, index[j]);
    found.starts.push_back(start);
  }
  for (std::size_t j = 0; j < grid.size; ++j)
    if (has_fringes(film, j)) found.step_fringes = std::max(found.step_fringes, grid.step_nm(j) * fringes_per_nm[j]);
  return found;
}

}  // namespace shabon::desk
