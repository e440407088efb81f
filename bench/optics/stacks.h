// Nanoseconds per wavelength, angle and layer for coherent stacks: reference and packets, and the share of the
// machine's peak that the packets reach.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Errors: loops whose results differ.
Status bench_stacks(Report& report, int repetitions);

}  // namespace shabon::bench
