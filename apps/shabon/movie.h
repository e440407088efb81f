// Frames as a movie, by the program ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <string>

#include "shabon/base/result.h"

namespace shabon::app {

// Whether ffmpeg can be called.
bool has_ffmpeg();

// `frames` is a pattern such as "DIR/frame.%04d.png". H.264 with all colours (4:4:4 would not play everywhere: 4:2:0),
// or what the ending of `movie` asks for. The movie appears when it is whole. Errors: Failure::file with what ffmpeg
// said.
Status write_movie(const std::string& frames, int first, int count, double frames_per_second,
                   const std::filesystem::path& movie);

}  // namespace shabon::app
