// Where a program spends its time: its processor time is cut into ticks, and at each the place in the code is noted.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::bench {

// One place: the library or program it lies in, and the source files that it comes from, the innermost of the
// functions that the compiler put into each other first. Without line tables (-g1) there are no files.
struct Place {
  std::string object;
  std::vector<std::string> files;
  std::uint64_t ticks = 0;
};

// Runs `work` on this thread and notes where it is, up to once in a millisecond of processor time. Needs binutils' addr2line.
// Errors: no timer, no addr2line.
Result<std::vector<Place>> sampled(const std::function<void()>& work);

}  // namespace shabon::bench
