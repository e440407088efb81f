// SIGINT and SIGTERM as a wish to stop: the work keeps what is finished.
#pragma once

#include "shabon/base/progress.h"

namespace shabon::app {

// While it lives, the first signal sets the flag and a second one ends the program at once. Signals that follow within
// half a second count as the same one: `timeout` and some terminals deliver each of theirs twice.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const StopFlag& stop() const;
  bool interrupted() const;
  int exit_code() const;  // 130 for SIGINT, 143 for SIGTERM; only when interrupted()
};

}  // namespace shabon::app
