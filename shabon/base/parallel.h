// Loops over several threads. The result must not depend on their number: each index writes only what is its own.
#pragma once

#include <cstddef>
#include <functional>

namespace shabon {

// Calls body(i) for every i in [0, count) on at most `threads` threads (0: one per core). Returns when all are done.
// `body` must not throw. Without a thread library (a browser) the loop runs in order on the caller's thread.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

// The number of threads that `threads` stands for.
int thread_count(int threads);

}  // namespace shabon
