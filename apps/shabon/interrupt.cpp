#include "interrupt.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>

namespace shabon::app {

namespace {

constexpr int signals[] = {SIGINT, SIGTERM};
constexpr std::int64_t same_signal_ns = 500'000'000;
constexpr int exit_code_base = 128;  // the shells' convention for a program ended by a signal

StopFlag stop_flag{false};
std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_time_ns{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

extern "C" void on_signal(int signal_number) {
  const std::int64_t now = now_ns();
  int none = 0;
  if (first_signal.compare_exchange_strong(none, signal_number)) {
    first_time_ns = now;
    stop_flag = true;
  } else if (now - first_time_ns > same_signal_ns) {
    ::_exit(exit_code_base + signal_number);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  ::sigemptyset(&action.sa_mask);
  for (const int number : signals) ::sigaddset(&action.sa_mask, number);
  action.sa_flags = SA_RESTART;
  for (const int number : signals) ::sigaction(number, &action, nullptr);
}

InterruptGuard::~InterruptGuard() {
  for (const int number : signals) ::signal(number, SIG_DFL);
}

const StopFlag& InterruptGuard::stop() const { return stop_flag; }
bool InterruptGuard::interrupted() const { return first_signal != 0; }
int InterruptGuard::exit_code() const { return exit_code_base + first_signal; }

}  // namespace shabon::app
