// shabon animate: for each frame the scene at its time -> Sensor -> picture; then a movie. Simulated films run along.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "command.h"
#include "film_news.h"
#include "frame_folder.h"
#include "interrupt.h"
#include "movie.h"
#include "options.h"
#include "picture_files.h"
#include "progress_bar.h"
#include "render_report.h"
#include "scene_input.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/render/render.h"
#include "shabon/scene/running_films.h"
#include "shabon/scene/schema_fields.h"
#include "streams.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

constexpr long long most_frames = 1000000, most_threads = 1024;
constexpr Range rate_range{.low = 0.01, .high = 1e5};
constexpr Range seconds_range{.low = 0, .high = 1e6, .low_open = true};

struct AnimateCommand {
  SceneInput scene;
  std::optional<std::string> folder, movie;
  std::optional<long long> first, last, threads;
  std::optional<double> seconds, rate, start_s, exposure_ev;
  std::size_t kind = 0;  // of picture_kinds()
  bool resume = false, quiet = false;

  double frames_per_second() const { return rate.value_or(25); }
  int first_frame() const { return static_cast<int>(first.value_or(0)); }
  int last_frame() const {
    if (last) return static_cast<int>(*last);
    return std::max(first_frame(), static_cast<int>(std::ceil(seconds.value_or(4) * frames_per_second() - 1e-9)) - 1);
  }
  double time_of(int frame) const { return start_s.value_or(0) + frame / frames_per_second(); }
  const PictureKind& picture() const { return picture_kinds()[kind]; }
  fs::path file_of(int frame) const {
    return fs::path(*folder) / fmt::format("frame.{:04}{}", frame, picture().ending);
  }
};

// Whether the picture of a frame is there to its end.
bool is_whole(const fs::path& file) {
  return same_name(file.extension().string(), ".png") ? io::read_png(file).ok() : io::read_exr(file).ok();
}

// The scene of a frame. Each has random numbers of its own: what is left of the noise does not stand still over the
// moving picture.
Result<LoadedScene> loaded_at(const AnimateCommand& command, int frame, bool warn) {
  SceneInput input = command.scene;
  input.flags.push_back(fmt::format("time_s={}", command.time_of(frame)));
  input.warn = warn;
  Result<LoadedScene> loaded = load(input);
  if (loaded) loaded->scene.render.seed += static_cast<std::uint64_t>(frame);
  return loaded;
}

// Everything that the frames of a folder have in common: the scene but for its time, and the flags that shape them.
Result<KeyValues> shared_values(const AnimateCommand& command) {
  const auto scene = scene_values(command.scene);
  if (!scene) return scene.errors();
  KeyValues values = {{"--fps", format_number(command.frames_per_second())},
                      {"--start", format_number(command.start_s.value_or(0))},
                      {"--exposure", format_number(command.exposure_ev.value_or(0))}};
  for (const auto& [key, value] : *scene)
    if (key != "time_s") values.emplace_back(key, value);
  return values;
}

class Animation {
 public:
  Animation(const AnimateCommand& command, KeyValues shared, const InterruptGuard& interrupt)
      : command_(command), shared_(std::move(shared)), interrupt_(interrupt), bar_(command.quiet, "animating") {}

  int run() {
    int code = success;
    for (frame_ = command_.first_frame(); frame_ <= command_.last_frame() && !interrupt_.interrupted(); ++frame_) {
      if (command_.resume && is_whole(command_.file_of(frame_))) continue;
      if (code = one_frame(); code != success || interrupt_.interrupted()) break;
    }
    bar_.finish();
    return finish(code);
  }

 private:
  int one_frame() {
    auto loaded = loaded_at(command_, frame_, !running_);
    if (!loaded) return report(loaded.errors());
    if (!running_)
      if (const Status started = start(loaded->scene); !started) return report(started.errors());
    const Status advanced = running_->advance_to(command_.time_of(frame_), &interrupt_.stop());
    if (const Diagnostics news = running_->news(); !news.empty()) {
      bar_.finish();
      report(news);
    }
    if (!advanced) return report(advanced.errors());
    if (interrupt_.interrupted()) return success;
    running_->show_in(loaded->scene);
    render::RenderOptions options;
    options.threads = static_cast<int>(command_.threads.value_or(0));
    options.stop = &interrupt_.stop();
    const int count = command_.last_frame() - command_.first_frame() + 1;
    options.progress = [&](double done) { bar_.update((frame_ - command_.first_frame() + done) / count); };
    render::Sensor sensor(loaded->scene.width, loaded->scene.height);
    const auto done = render::render(loaded->scene, options, sensor);
    if (!done) return report(done.errors());
    if (done->interrupted) return success;  // half a frame is none
    scene::Development development = loaded->scene.development;
    development.exposure_ev += command_.exposure_ev.value_or(0);
    io::Metadata metadata = picture_metadata(*loaded, command_.scene.overrides, *done);
    metadata.emplace_back("frame", std::to_string(frame_));
    metadata.emplace_back("time_s", format_number(command_.time_of(frame_)));
    const Status written = command_.picture().write(command_.file_of(frame_), sensor, development, metadata);
    if (!written) return report(written.errors());
    ++rendered_;
    return success;
  }

  // With the first frame that is made.
  Status start(const scene::Scene& scene) {
    auto started = scene::RunningFilms::start(scene);
    if (!started) return started.errors();
    running_ = std::move(started).value();
    report(running_->forecast(command_.time_of(command_.last_frame())));
    return write_key_values(fs::path(*command_.folder) / animation_name, shared_);
  }

  int finish(int code) {
    const std::string folder = printable(*command_.folder);
    if (code != success || interrupt_.interrupted()) {
      if (running_) say(fmt::format("wrote {} frames in '{}'; --resume makes the others", rendered_, folder));
      return code != success ? code : interrupt_.exit_code();
    }
    if (const auto broken = running_ ? running_->rupture() : std::nullopt) say(rupture_text(*broken));
    if (!command_.quiet) say(fmt::format("wrote {} frames in '{}'", rendered_, folder));
    if (!command_.movie) return success;
    const Status made =
        write_movie(*command_.folder, command_.first_frame(), command_.last_frame() - command_.first_frame() + 1,
                    command_.frames_per_second(), *command_.movie);
    if (!made) return report(made.errors());
    if (!command_.quiet) say(fmt::format("wrote {}", printable(*command_.movie)));
    return success;
  }

  const AnimateCommand& command_;
  const KeyValues shared_;
  const InterruptGuard& interrupt_;
  ProgressBar bar_;
  std::optional<scene::RunningFilms> running_;
  int frame_ = 0, rendered_ = 0;
};

// Everything that can be known to fail before the first frame.
Status check(const AnimateCommand& command) {
  if (!command.folder) return fail(Failure::usage, "expected -o DIR, a folder for the frames; got none");
  if (command.last_frame() < command.first_frame())
    return fail(Failure::usage, fmt::format("--last: expected a frame from {} on, got {}", command.first_frame(),
                                            command.last_frame()));
  if (command.movie && command.picture().ending != ".png")
    return fail(Failure::usage, "--movie: expected frames as png, got exr");
  std::error_code error;
  fs::create_directories(*command.folder, error);
  if (error)
    return fail(Failure::file, fmt::format("cannot make '{}': {}", printable(*command.folder), error.message()));
  if (!command.resume && fs::exists(command.file_of(command.first_frame()), error))
    return fail(Failure::usage, fmt::format("'{}' is there already: expected --resume to keep it, or another folder",
                                            printable(command.file_of(command.first_frame()).string())));
  if (command.movie)
    if (const Status movie = check_movie(*command.movie); !movie) return movie;
  return io::check_writable(command.file_of(command.first_frame()));
}

int run_animate(const AnimateCommand& command) {
  if (const Status checked = check(command); !checked) return report(checked.errors());
  auto shared = shared_values(command);
  if (!shared) return report(shared.errors());
  Diagnostics warnings;
  const Status same = check_frame_folder(*command.folder, *shared, warnings);
  report(warnings);
  if (!same) return report(same.errors());
  const InterruptGuard interrupt;
  return Animation(command, std::move(shared).value(), interrupt).run();
}

}  // namespace

Action declare_animate(CLI::App& app) {
  const auto command = std::make_shared<AnimateCommand>();
  add_scene_input(app, command->scene);
  add_text(app, "-o,--output", command->folder, "DIR", "Folder for the frames, made where it is missing");
  add_number(app, "--seconds", command->seconds, seconds_range, "s", "Length of the animation [4]");
  add_number(app, "--fps", command->rate, rate_range, "1/s", "Frames a second [25]");
  add_number(app, "--start", command->start_s, Range{.low = 0, .high = 1e6}, "s", "Time of frame 0 [0]");
  add_integer(app, "--first", command->first, 0, most_frames, "First frame of a part of the animation [0]");
  add_integer(app, "--last", command->last, 0, most_frames, "Last frame of a part of the animation");
  std::vector<std::string_view> endings;
  for (const PictureKind& kind : picture_kinds()) endings.push_back(kind.ending.substr(1));
  add_name(app, "--format", command->kind, endings, "Kind of picture");
  add_text(app, "--movie", command->movie, "FILE", "Also a movie of the frames, such as film.mp4; needs ffmpeg");
  add_scene_integer(app, command->scene, "--samples", "render.samples", scene::samples_range, "Camera samples a pixel");
  add_scene_integer(app, command->scene, "--seed", "render.seed", scene::seed_range, "Start of the random numbers");
  add_integer(app, "--threads", command->threads, 1, most_threads, "Threads; never changes the pictures [one a core]");
  add_number(app, "--exposure", command->exposure_ev, scene::exposure_range, "EV",
             "Brightens PNG pictures by 2^EV, on top of image.exposure_ev [0]");
  app.add_flag("--resume", command->resume,
               "Leaves out frames that are there, and whole; the scene and its settings must be the same");
  app.add_flag("--quiet", command->quiet, "No progress; only warnings and errors");
  app.footer(
      R"(Frames are frame.0000.png and so on, each a picture of the scene at its time (time_s): films age, simulated films run,
sequences of maps go on. An interrupted run keeps every finished frame. animation.csv beside them says what they show: frames of
another scene, size or setting are not added to them.

Examples:
  shabon animate scenes/draining-film/scene.yaml -o drain --seconds 10 --movie drain.mp4
  shabon animate scene.yaml -o part --first 100 --last 149 --samples 16 --size 400x300
  shabon animate scene.yaml -o part --resume)");
  return [command] { return run_animate(*command); };
}

}  // namespace shabon::app
