#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "streams.h"

namespace shabon::app {

namespace {

constexpr int bar_characters = 30;
constexpr std::chrono::milliseconds terminal_interval{100};
constexpr std::chrono::seconds log_interval{10};

std::string minutes_and_seconds(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

void write_message(const std::string& text) {
  // The picture does not depend on whether its progress could be shown.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

ProgressBar::ProgressBar(bool quiet, std::string what)
    : what_(std::move(what)), quiet_(quiet), terminal_(is_terminal_message()) {}
ProgressBar::~ProgressBar() { finish(); }

std::string ProgressBar::line(double done) const {
  const int filled = static_cast<int>(done * bar_characters);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  // The first moments say little about the rest.
  const bool known = done > 0 && elapsed > 0.5;
  const std::string left = known ? minutes_and_seconds(elapsed * (1 - done) / done) + " left" : "";
  return fmt::format("{} [{}{}] {:3.0f} % {}", what_, std::string(static_cast<std::size_t>(filled), '#'),
                     std::string(static_cast<std::size_t>(bar_characters - filled), '.'), std::floor(done * 100), left);
}

void ProgressBar::update(double done) {
  if (quiet_) return;
  done = std::clamp(done, 0.0, 1.0);
  const Clock::time_point now = Clock::now();
  if (now - last_ < (terminal_ ? Clock::duration(terminal_interval) : Clock::duration(log_interval))) return;
  last_ = now;
  drawn_ = terminal_;
  write_message(terminal_ ? "\r" + line(done) + "\x1b[K" : line(done) + "\n");
}

void ProgressBar::finish() {
  if (drawn_) write_message("\r\x1b[K");
  drawn_ = false;
}

}  // namespace shabon::app
