// Frames as a movie, by the program ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <string>

#include "shabon/base/result.h"

namespace shabon::app {

// Everything that can be known to fail before the first frame. Errors: Failure::usage for an ending that is no movie's,
// Failure::file when it cannot be written or ffmpeg cannot be called.
Status check_movie(const std::filesystem::path& movie);

// The frames are FOLDER/frame.0000.png and so on. H.264 with colours at half the resolution (4:2:0), which plays
// everywhere, in BT.709. The movie appears when it is whole. Errors: Failure::file with what ffmpeg said.
Status write_movie(const std::filesystem::path& folder, int first, int count, double frames_per_second,
                   const std::filesystem::path& movie);

}  // namespace shabon::app
