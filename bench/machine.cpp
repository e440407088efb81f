#include "bench/machine.h"

#include <fmt/format.h>

#include <fstream>

#include "shabon/api/version.h"
#include "shabon/base/parallel.h"
#include "shabon/render/render.h"

namespace shabon::bench {

namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

}  // namespace

std::string machine_line() {
  return fmt::format("{}, {} cores. Shabon {} for {}, {}.", processor_name(), thread_count(0), version(),
                     render::instruction_set(), SHABON_BENCH_COMPILER);
}

}  // namespace shabon::bench
