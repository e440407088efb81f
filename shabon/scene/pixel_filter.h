// The pixel filter: how much each point of the picture's plane counts for a pixel. The same in x and y, and their
// product. Samples are placed by its density (Ernst, Stamminger, Greiner 2006, "Filter importance sampling"), so that
// all of them weigh the same.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>

namespace shabon::scene {

enum class FilterKind { box, tent, gaussian, blackman_harris };

struct FilterEntry {
  FilterKind kind;
  std::string_view name, description;
  double default_width_px;
  double (*shape)(double t);
};

// From t = -1 to 1 across the width; even; on any scale.
namespace filter_shapes {

inline double box(double) { return 1; }

inline double tent(double t) { return 1 - std::abs(t); }

// Cut off at three standard deviations.
inline double gaussian(double t) { return std::exp(-0.5 * (3 * t) * (3 * t)); }

// The four-term window with the smallest side lobes (F. J. Harris, Proc. IEEE 66 (1978) 51, table 1, -92 dB).
inline double blackman_harris(double t) {
  const double phase = std::numbers::pi * t;
  return 0.35875 + 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) + 0.01168 * std::cos(3 * phase);
}

}  // namespace filter_shapes

// The closed set; the default first.
inline constexpr FilterEntry pixel_filters[] = {
    {FilterKind::box, "box", "all of the pixel alike", 1, filter_shapes::box},
    {FilterKind::tent, "tent", "falls off in straight lines", 2, filter_shapes::tent},
    {FilterKind::gaussian, "gaussian", "a bell of a standard deviation of a sixth of the width", 3,
     filter_shapes::gaussian},
    {FilterKind::blackman_harris, "blackman-harris", "a bell that ends smoothly", 3.3, filter_shapes::blackman_harris},
};

class PixelFilter {
 public:
  // The pixel itself: every point of it counts the same.
  PixelFilter() = default;
  // `width_px` > 0 is the whole width; without one, the filter's own.
  explicit PixelFilter(FilterKind kind, std::optional<double> width_px = {});

  FilterKind kind() const { return kind_; }
  double width_px() const { return width_px_; }
  bool is_the_pixel() const { return kind_ == FilterKind::box && width_px_ == 1; }

  // Where a sample lies, from the pixel's middle: `u` in [0, 1) through the inverse cumulative of the filter.
  double offset_px(double u) const;

  // Per pixel; its integral over the width is 1.
  double density(double offset_px) const;

 private:
  // The filter's curve as straight lines between this many points and one: the cumulative is then inverted by a square
  // root. Second moments differ from the curve's by less than 1e-5 of a width squared.
  static constexpr std::size_t pieces = 512;
  struct Curve {
    std::array<double, pieces + 1> density, cumulative;  // over t/2 + 1/2 in 0..1
    std::array<std::uint16_t, pieces + 1> first_piece;   // that may hold u = i/pieces
  };

  FilterKind kind_ = FilterKind::box;
  double width_px_ = 1;
  std::shared_ptr<const Curve> curve_;
};

}  // namespace shabon::scene
