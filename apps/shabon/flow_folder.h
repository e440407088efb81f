// The folder of a simulation: its settings, one row of diagnostics a frame, and checkpoints to go on from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/film/flow/flow.h"

namespace shabon::app {

class FlowFolder {
 public:
  // A folder that holds no simulation yet; it is made where it is missing. Errors: Failure::usage when it holds one,
  // Failure::file when it cannot be made or written.
  static Result<FlowFolder> begin(const std::filesystem::path& path, double frames_per_second);

  // A simulation to go on with. Errors: Failure::file, Failure::content when its files are damaged.
  static Result<FlowFolder> reopen(const std::filesystem::path& path);

  double frames_per_second() const { return frames_per_second_; }

  struct Start {
    film::FilmFlow flow;
    int frame;
  };
  // The flow at the last checkpoint at or before `frame` (none: the last of all). Rows of later frames are forgotten.
  Result<Start> latest(std::optional<int> frame);

  // Adds the row of a frame. Everything is on disk when it returns.
  Status add_row(int frame, const film::FlowReport& report);
  Status write_checkpoint(int frame, const std::vector<std::byte>& bytes);
  Status write(const std::string& name, std::string_view bytes);
  const std::filesystem::path& path() const { return path_; }

 private:
  FlowFolder(std::filesystem::path path, double frames_per_second)
      : path_(std::move(path)), frames_per_second_(frames_per_second) {}
  Status write_rows();

  std::filesystem::path path_;
  double frames_per_second_;
  std::vector<std::vector<double>> rows_;  // frame first
};

}  // namespace shabon::app
