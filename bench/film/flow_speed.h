// How fast the simulated film runs, in film time over processor time.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Errors: a film that does not run.
Status bench_flow(Report& report, int repetitions, bool quick);

}  // namespace shabon::bench
