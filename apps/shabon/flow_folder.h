// The folder of a simulation: its settings (simulation.csv), its film (film.csv), one row of diagnostics a frame, and
// checkpoints to go on from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flow_frame.h"
#include "flow_rows.h"
#include "shabon/base/result.h"
#include "shabon/film/flow/flow.h"

namespace shabon::app {

// What every frame of a simulation has in common.
struct FlowSettings {
  double frames_per_second = 25;
  int checkpoint_every = 10;  // frames
  MapSizes maps;
  std::vector<const FrameKind*> kinds;
};

class FlowFolder {
 public:
  // A folder that holds no simulation to go on with yet; it is made where it is missing. Errors: Failure::usage when it
  // holds one, Failure::file when it cannot be made or written.
  static Result<FlowFolder> begin(const std::filesystem::path& path, const FlowSettings& settings,
                                  const film::FlowDesc& film);

  // A simulation to go on with. Errors: Failure::file, Failure::content when its files are damaged; what the run can go
  // on without is a warning.
  static Result<FlowFolder> reopen(const std::filesystem::path& path, Diagnostics& warnings);

  const FlowSettings& settings() const { return settings_; }
  // Errors as write().
  Status change(const FlowSettings& settings);

  struct Start {
    film::FilmFlow flow;
    int frame;
  };
  // The flow at the last checkpoint at or before `frame` (none: the last). Rows and files of later frames are
  // forgotten; rows that are missing before are a warning. Errors: Failure::content when there is none, or it is
  // damaged, of another film or of another frame.
  Result<Start> latest(std::optional<int> frame, Diagnostics& warnings);

  // Adds the row of a frame. Everything is on disk when it returns.
  Status add_row(int frame, const film::FlowReport& report);
  Status write_checkpoint(int frame, const std::vector<std::byte>& bytes);
  std::optional<int> last_checkpoint() const;  // its frame
  Status write(const std::string& name, std::string_view bytes);
  const std::filesystem::path& path() const { return path_; }

 private:
  FlowFolder(std::filesystem::path path, FlowSettings settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}
  void forget_after(int frame);

  std::filesystem::path path_;
  FlowSettings settings_;
  FlowRows rows_;
};

}  // namespace shabon::app
