// diagnostics.csv of a simulation: one row of numbers a frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/film/flow/report.h"

namespace shabon::app {

class FlowRows {
 public:
  // What there is of the table. A last line that does not end, as an interrupted write leaves it, is left out without a
  // word, other damaged lines with a warning. Errors: Failure::file when it cannot be read, Failure::content when it
  // begins with other columns than ours.
  static Result<FlowRows> read(const std::filesystem::path& path, Diagnostics& warnings);

  void forget_after(int frame);
  // In place of a row of the same frame.
  void put(int frame, const film::FlowReport& report);
  // The frames from 0 to `last` that have no row, as "3, 5 to 9".
  std::optional<std::string> missing_until(int last) const;
  std::string text() const;

 private:
  std::vector<std::vector<double>> rows_;  // frame first, rising
};

}  // namespace shabon::app
