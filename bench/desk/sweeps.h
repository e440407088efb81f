// Series of colours: one layer of a stack with many thicknesses.
#pragma once

#include "bench/report.h"

namespace shabon::bench {

Status bench_sweeps(Report& report, int repetitions);

}  // namespace shabon::bench
