// How far a long piece of work has come, and the wish to stop it.
#pragma once

#include <atomic>
#include <functional>

namespace shabon {

// Called with the finished share, 0..1, from whichever thread finished a piece, never from two at once.
using ProgressReport = std::function<void(double done)>;

// Set from a signal handler or another thread; work stops at the next piece and keeps what is finished.
using StopFlag = std::atomic<bool>;
static_assert(StopFlag::is_always_lock_free);

}  // namespace shabon
