#include "shabon/base/parallel.h"

#if !defined(__EMSCRIPTEN__)
#include <atomic>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace shabon {

#if defined(__EMSCRIPTEN__)

int thread_count(int) { return 1; }

void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

#else

int thread_count(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  const int used = thread_count(threads);
  if (used == 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  // More threads than cores only when asked for: the arena alone would be cut to the number of cores.
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(used));
  tbb::task_arena arena(used);
  // What oneTBB orders anyway, said once more in the language's own atomics: the thread sanitizer cannot see into it.
  std::atomic<std::size_t> begun{0}, finished{0};
  begun.store(1, std::memory_order_release);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          begun.load(std::memory_order_acquire);
          for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
          finished.fetch_add(1, std::memory_order_release);
        },
        tbb::simple_partitioner());
  });
  finished.load(std::memory_order_acquire);
}

#endif

}  // namespace shabon
