// The split tree against single paths: the time to a picture of one percent error.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// `repetitions` pairs of pictures each. Errors: a scene that does not load.
Status bench_transports(Report& report, int repetitions);

}  // namespace shabon::bench
