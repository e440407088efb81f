// How much of the film lay outside of the range of 16-bit pictures, and was clipped.
#pragma once

#include "flow_frame.h"
#include "shabon/base/result.h"

namespace shabon::app {

class PngClipping {
 public:
  // Of a frame that is written as that kind; kinds that clip nothing count for nothing.
  void add(const FrameKind& kind, const film::FilmFlow& flow, const MapSizes& sizes);
  // One warning over all frames, or none.
  Diagnostics warnings() const;

 private:
  double most_share_ = 0, most_time_s_ = 0;  // of the area, in the frame in which it was most
  double thinnest_nm_ = 0, thickest_nm_ = 0;
  std::array<double, 2> range_nm_ = {};
  int frames_ = 0;
};

}  // namespace shabon::app
