// Nanoseconds per ray to find the next shape of any kind: one by one, and by Embree's tree.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Errors: searches whose answers differ.
Status bench_next_shape(Report& report, int repetitions);

}  // namespace shabon::bench
