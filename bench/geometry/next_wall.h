// Nanoseconds per ray to find the next wall: spheres one by one, and by Embree's tree.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Errors: a scene that does not load, searches whose answers differ.
Status bench_next_wall(Report& report, int repetitions);

}  // namespace shabon::bench
