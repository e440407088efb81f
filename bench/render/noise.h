// How good a picture is for its time: seconds x mean squared error of the bubble under the windows.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// `thorough`: 16, 64 and 256 samples a pixel, several seeds, the surroundings turned, a grey film; else 16 only.
// Errors: a scene that does not load.
Status bench_noise(Report& report, bool thorough);

}  // namespace shabon::bench
