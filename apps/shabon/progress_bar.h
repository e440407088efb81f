// How far the picture has come, on standard error.
#pragma once

#include <chrono>
#include <string>

namespace shabon::app {

// On a terminal one line that is drawn again; elsewhere (a log file) a line now and then.
class ProgressBar {
 public:
  // `what` is being done: "rendering".
  explicit ProgressBar(bool quiet, std::string what = "rendering");
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(double done);  // 0..1; not from two threads at once
  void finish();             // leaves the line, so that messages start on one of their own

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(double done) const;

  std::string what_;
  bool quiet_, terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace shabon::app
