#include "movie.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <system_error>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/io/file.h"

extern char** environ;

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

// Players take untagged pictures for BT.601 or BT.709 as they like: convert, and tag what it is.
constexpr const char* to_bt709 =
    "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=in_range=pc:out_range=tv:out_color_matrix=bt709,format=yuv420p";

// The exit code of the program, with its messages in `log`; -1 when it cannot be called.
int called(std::vector<std::string> arguments, const fs::path& log) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

Status refuse(const fs::path& movie, const std::string& message) {
  Diagnostics errors = fail(Failure::file, message);
  errors.front().source = movie.string();
  return errors;
}

}  // namespace

Status check_movie(const fs::path& movie) {
  constexpr std::string_view endings[] = {".mp4", ".mkv", ".mov"};
  bool known = false;
  for (const std::string_view ending : endings) known |= same_name(movie.extension().string(), ending);
  if (!known)
    return fail(Failure::usage, fmt::format("--movie: expected a file ending in .mp4, .mkv or .mov, got '{}'",
                                            printable(movie.string())));
  if (const Status writable = io::check_writable(movie); !writable) return writable;
  if (called({"ffmpeg", "-version"}, "/dev/null") != 0)
    return fail(Failure::file,
                "--movie: expected the program ffmpeg to be installed; without --movie the frames are "
                "written alone");
  return Done{};
}

Status write_movie(const fs::path& folder, int first, int count, double frames_per_second, const fs::path& movie) {
  std::string frames;  // a pattern, in which % counts
  for (const char c : folder.string()) frames += c == '%' ? "%%" : std::string(1, c);
  frames += "/frame.%04d.png";
  // With the ending kept, which decides the form.
  const fs::path unfinished = movie.parent_path() / (".unfinished-" + movie.filename().string());
  const fs::path log = movie.parent_path() / (".unfinished-" + movie.filename().string() + ".log");
  std::vector<std::string> arguments = {"ffmpeg",
                                        "-y",
                                        "-loglevel",
                                        "error",
                                        "-framerate",
                                        fmt::format("{}", frames_per_second),
                                        "-start_number",
                                        std::to_string(first),
                                        "-i",
                                        frames,
                                        "-frames:v",
                                        std::to_string(count)};
  for (const char* argument :
       {"-c:v", "libx264", "-crf", "16", "-preset", "slow", "-vf", to_bt709, "-colorspace", "bt709", "-color_primaries",
        "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"})
    arguments.emplace_back(argument);
  arguments.push_back(unfinished.string());
  const int code = called(arguments, log);
  std::error_code error;
  const auto said = io::read_file(log, 1 << 20);
  fs::remove(log, error);
  if (code != 0) {
    fs::remove(unfinished, error);
    if (code < 0) return refuse(movie, "ffmpeg could not be called");
    const std::string reason = said ? std::string(trim(said->substr(0, said->find('\n')))) : std::string();
    return refuse(movie, "ffmpeg made no movie" + (reason.empty() ? "" : ": " + printable(reason, 200)));
  }
  fs::rename(unfinished, movie, error);
  if (error) return refuse(movie, error.message());
  return Done{};
}

}  // namespace shabon::app
