// How fast the whole renderer runs, what interference costs in it, and how it scales from 1 to 2 threads.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Renders everything `repetitions` times in turn, each with `samples` a pixel. Errors: a scene that does not load.
Status bench_speed(Report& report, int repetitions, int samples);

}  // namespace shabon::bench
