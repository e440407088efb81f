#include "bench/sampler.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/time.h>
#include <ucontext.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <map>
#include <memory>

namespace shabon::bench {

namespace {

constexpr std::size_t most_ticks = 1 << 20;
constexpr int tick_us = 1000;

// A signal handler may only touch what is there already.
std::vector<std::uintptr_t> noted(most_ticks);
std::atomic<std::size_t> noted_count{0};

void note(int, siginfo_t*, void* context) {
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  const auto place = static_cast<std::uintptr_t>(registers.gregs[REG_RIP]);
#elif defined(__aarch64__)
  const auto place = static_cast<std::uintptr_t>(registers.pc);
#else
  const std::uintptr_t place = 0;
#endif
  const std::size_t at = noted_count.load(std::memory_order_relaxed);
  if (at < most_ticks) noted[at] = place, noted_count.store(at + 1, std::memory_order_relaxed);
}

bool set_timer(int microseconds) {
  const timeval interval{0, microseconds};
  const itimerval timer{interval, interval};
  return setitimer(ITIMER_PROF, &timer, nullptr) == 0;
}

Status run_with_timer(const std::function<void()>& work) {
  struct sigaction action = {}, before = {};
  action.sa_sigaction = note;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  noted_count = 0;
  if (sigaction(SIGPROF, &action, &before) != 0 || !set_timer(tick_us))
    return fail(Failure::internal, "expected a timer of processor time, got none");
  work();
  set_timer(0);
  sigaction(SIGPROF, &before, nullptr);
  return Done{};
}

// How often each place inside one object was met, by its offset there.
using Offsets = std::map<std::uintptr_t, std::uint64_t>;

std::map<std::string, Offsets> by_object() {
  std::map<std::string, Offsets> objects;
  for (std::size_t i = 0; i < noted_count; ++i) {
    Dl_info info = {};
    const bool known = dladdr(reinterpret_cast<void*>(noted[i]), &info) != 0 && info.dli_fname != nullptr;
    const auto base = known ? reinterpret_cast<std::uintptr_t>(info.dli_fbase) : 0;
    ++objects[known ? info.dli_fname : "unknown"][noted[i] - base];
  }
  return objects;
}

// addr2line answers each address with its own line, then two lines for every function, innermost first.
Status add_places(const std::string& object, const Offsets& offsets, std::vector<Place>& places) {
  std::string command = fmt::format("addr2line -a -i -f -e '{}'", object);
  for (const auto& [offset, ticks] : offsets) command += fmt::format(" {:#x}", offset);
  const std::unique_ptr<FILE, int (*)(FILE*)> answer(popen((command + " 2>/dev/null").c_str(), "r"), pclose);
  if (!answer) return fail(Failure::internal, "expected addr2line of binutils, got no answer");
  auto tick = offsets.begin();
  bool at_function = true;
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), int(buffer.size()), answer.get())) {
    const std::string line = buffer.data();
    if (line.starts_with("0x")) {
      if (tick == offsets.end()) break;
      places.push_back({object, {}, (tick++)->second});
      at_function = true;
    } else if (std::exchange(at_function, !at_function) == false && !places.empty()) {
      places.back().files.push_back(line.substr(0, line.rfind(':')));
    }
  }
  if (tick != offsets.end()) return fail(Failure::internal, "expected addr2line of binutils, got too few answers");
  return Done{};
}

}  // namespace

Result<std::vector<Place>> sampled(const std::function<void()>& work) {
  if (const Status done = run_with_timer(work); !done) return done.errors();
  std::vector<Place> places;
  for (const auto& [object, offsets] : by_object()) {
    if (object.find("libshabon") == std::string::npos) {  // nothing of ours: its files do not matter
      Place whole{object, {}, 0};
      for (const auto& [offset, ticks] : offsets) whole.ticks += ticks;
      places.push_back(whole);
    } else if (const Status done = add_places(object, offsets, places); !done) {
      return done.errors();
    }
  }
  return places;
}

}  // namespace shabon::bench
