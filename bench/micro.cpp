#include "bench/micro.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace shabon::bench {

namespace {

// Collects instead of printing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t count) : seconds(count) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds[std::stoul(run.run_name.function_name)].push_back(run.cpu_accumulated_time /
                                                                static_cast<double>(run.iterations));
    }
  }
  std::vector<std::vector<double>> seconds;  // per run of each loop
};

void set_options(int repetitions, double seconds_each) {
  std::string arguments[] = {"shabon_bench", fmt::format("--benchmark_repetitions={}", repetitions),
                             fmt::format("--benchmark_min_time={}", seconds_each),
                             "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
}

}  // namespace

std::vector<Spread> nanoseconds_per_item(const std::vector<Micro>& loops, int repetitions, double seconds_each) {
  set_options(repetitions, seconds_each);
  for (std::size_t i = 0; i < loops.size(); ++i)
    benchmark::RegisterBenchmark(std::to_string(i).c_str(), [&loops, i](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(loops[i].run());
    });
  Collector collector(loops.size());
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Spread> result;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (double& value : collector.seconds[i]) value *= 1e9 / loops[i].items;
    result.push_back(spread_of(collector.seconds[i]));
  }
  return result;
}

}  // namespace shabon::bench
