#include "png_clipping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "streams.h"

namespace shabon::app {

void PngClipping::add(const FrameKind& kind, const film::FilmFlow& flow, const MapSizes& sizes) {
  if (!kind.clips || !sizes.png_range_nm) return;
  range_nm_ = *sizes.png_range_nm;
  const auto thickness = flow.thickness_m();
  const auto areas = flow.areas_m2();
  double outside = 0, all = 0;
  for (std::size_t c = 0; c < thickness.size(); ++c) {
    const double nm = thickness[c] * 1e9;
    all += areas[c];
    if (nm < range_nm_[0] || nm > range_nm_[1]) outside += areas[c];
    thinnest_nm_ = frames_ == 0 && c == 0 ? nm : std::min(thinnest_nm_, nm);
    thickest_nm_ = frames_ == 0 && c == 0 ? nm : std::max(thickest_nm_, nm);
  }
  if (outside / all > most_share_) most_share_ = outside / all, most_time_s_ = flow.time_s();
  ++frames_;
}

Diagnostics PngClipping::warnings() const {
  if (most_share_ == 0) return {};
  return {warning_of(fmt::format(
      "--png-range {} {}: up to {} % of the film, at {} s, lay outside and became black or white; --png-range {} {} "
      "holds all of these frames",
      format_number(range_nm_[0]), format_number(range_nm_[1]), format_number(100 * most_share_, 3),
      format_number(most_time_s_, 4), std::floor(thinnest_nm_), std::ceil(thickest_nm_)))};
}

}  // namespace shabon::app
