// Pictures numbered by frame.
#pragma once

#include <string>

#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

// The file or the two files between which a moment lies.
struct Frames {
  std::string first, second;  // the second is empty where the moment is that of the first
  double share = 0;           // of the second, 0..1
};

inline constexpr double usual_frames_per_second = 24;

// Where a file's name holds a run of '#', the last such run stands for the frame's number, with zeros in front.
bool numbered(const std::string& file);

// Frames follow each other from `first_frame` at time 0; the last one stays. A file that is not numbered is one frame.
Frames frames_at(const ThicknessMapDesc& map, double time_s);

}  // namespace shabon::scene
