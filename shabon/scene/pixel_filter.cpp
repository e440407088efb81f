#include "shabon/scene/pixel_filter.h"

#include <algorithm>

namespace shabon::scene {

namespace {

const FilterEntry& entry_of(FilterKind kind) {
  for (const FilterEntry& entry : pixel_filters)
    if (entry.kind == kind) return entry;
  return pixel_filters[0];
}

}  // namespace

PixelFilter::PixelFilter(FilterKind kind, std::optional<double> width_px)
    : kind_(kind), width_px_(width_px.value_or(entry_of(kind).default_width_px)) {
  auto curve = std::make_shared<Curve>();
  const auto& shape = entry_of(kind).shape;
  for (std::size_t i = 0; i <= pieces; ++i)
    curve->density[i] = std::max(0.0, shape(2 * static_cast<double>(i) / pieces - 1));
  curve->cumulative[0] = 0;
  for (std::size_t i = 0; i < pieces; ++i)
    curve->cumulative[i + 1] = curve->cumulative[i] + (curve->density[i] + curve->density[i + 1]) / (2.0 * pieces);
  const double total = curve->cumulative[pieces];
  for (double& value : curve->density) value /= total;
  for (double& value : curve->cumulative) value /= total;
  std::size_t piece = 0;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double u = static_cast<double>(i) / pieces;
    while (piece + 1 < pieces && curve->cumulative[piece + 1] <= u) ++piece;
    curve->first_piece[i] = static_cast<std::uint16_t>(piece);
  }
  curve_ = std::move(curve);
}

double PixelFilter::offset_px(double u) const {
  if (!curve_) return u - 0.5;
  const Curve& curve = *curve_;
  const auto cell = static_cast<std::size_t>(u * pieces);
  // The last point of those between which u may lie whose cumulative is at most u.
  const auto begin = curve.cumulative.begin();
  const auto above = std::upper_bound(begin + curve.first_piece[cell] + 1, begin + curve.first_piece[cell + 1] + 1, u);
  const auto i = static_cast<std::size_t>(above - begin) - 1;
  // Within a piece the density runs from a to b: u = cumulative + a s + (b - a) s^2 pieces/2, solved without
  // cancellation.
  const double a = curve.density[i], slope = (curve.density[i + 1] - a) * pieces, rest = u - curve.cumulative[i];
  const double root = a + std::sqrt(std::max(0.0, a * a + 2 * slope * rest));
  const double s = root > 0 ? 2 * rest / root : 0;
  return width_px_ * (static_cast<double>(i) / pieces + std::min(s, 1.0 / pieces) - 0.5);
}

double PixelFilter::density(double offset_px) const {
  const double place = (offset_px / width_px_ + 0.5) * pieces;
  if (!(place >= 0 && place <= pieces)) return 0;
  if (!curve_) return 1 / width_px_;
  const auto i = std::min(static_cast<std::size_t>(place), pieces - 1);
  const double f = place - static_cast<double>(i);
  return (curve_->density[i] + f * (curve_->density[i + 1] - curve_->density[i])) / width_px_;
}

}  // namespace shabon::scene
