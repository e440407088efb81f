// Nanoseconds per film event and wavelength: packets against plain loops with std::cos.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

// Errors: a scene that does not load, loops whose results differ.
Status bench_films(Report& report, int repetitions);

}  // namespace shabon::bench
