// Short loops, timed by Google Benchmark: repetitions of all of them in random order, so that a slow spell of the
// machine falls on all alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/report.h"

namespace shabon::bench {

struct Micro {
  std::string name;
  std::function<double()> run;  // its result keeps the compiler from leaving the work out
  double items = 1;             // done by one run
};

// Nanoseconds of processor time per item, for each of `loops`.
std::vector<Spread> nanoseconds_per_item(const std::vector<Micro>& loops, int repetitions, double seconds_each);

}  // namespace shabon::bench
