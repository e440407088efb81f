#include "shabon/scene/frames.h"

#include <algorithm>
#include <cmath>

namespace shabon::scene {

namespace {

std::string file_of(const std::string& name, long long frame) {
  const std::size_t end = name.find_last_of('#') + 1;
  std::size_t start = end;
  while (start > 0 && name[start - 1] == '#') --start;
  std::string digits = std::to_string(frame);
  if (digits.size() < end - start) digits.insert(0, end - start - digits.size(), '0');
  return name.substr(0, start) + digits + name.substr(end);
}

}  // namespace

bool numbered(const std::string& file) { return file.find('#') != std::string::npos; }

Frames frames_at(const ThicknessMapDesc& map, double time_s) {
  if (!numbered(map.file)) return {map.file, {}, 0};
  constexpr double same_moment = 1e-6;  // in frames: 1/24 s and such have no exact number
  double at = map.first_frame.value_or(0) + time_s * map.frames_per_second.value_or(usual_frames_per_second);
  if (map.last_frame) at = std::min(at, static_cast<double>(*map.last_frame));
  const double whole = std::floor(at + same_moment), share = at - whole;
  const auto frame = static_cast<long long>(whole);
  if (share < same_moment) return {file_of(map.file, frame), {}, 0};
  return {file_of(map.file, frame), file_of(map.file, frame + 1), share};
}

}  // namespace shabon::scene
