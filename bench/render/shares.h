// What the renderer's time goes into: the search of the next surface, optics, pictures, and the rest.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Renders each of some scenes on one thread for about `seconds`. Errors: a scene that does not load, no sampler.
Status bench_shares(Report& report, double seconds);

}  // namespace shabon::bench
