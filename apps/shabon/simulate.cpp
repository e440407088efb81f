// shabon simulate: text -> FlowDesc -> FilmFlow, from frame to frame -> pictures, meshes, diagnostics, checkpoints.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "command.h"
#include "film_news.h"
#include "flow_folder.h"
#include "flow_frame.h"
#include "interrupt.h"
#include "options.h"
#include "png_clipping.h"
#include "progress_bar.h"
#include "shabon/api/resolvers.h"
#include "shabon/api/version.h"
#include "shabon/film/flow/dryness.h"
#include "shabon/film/flow/presets.h"
#include "shabon/io/file.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/flow_file.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr Range seconds_range{.low = 0, .high = 1e5, .low_open = true};
constexpr Range rate_range{.low = 0.01, .high = 1e5};
constexpr int most_frames = 1000000;
constexpr double gltf_wavelength_nm = 587.6;  // the d line of helium, at which indices are commonly given
constexpr const char* usual_medium = "soap";

struct SimulateCommand {
  std::optional<std::string> file, preset, folder, medium;
  std::vector<std::string> overrides, kinds;
  std::optional<double> seconds, rate;
  std::optional<long long> checkpoint_every, resume_frame, lat_long_width, cube_edge;
  std::vector<double> png_range;
  bool resume = false, quiet = false;

  bool goes_on() const { return resume || resume_frame; }
  double seconds_asked() const { return seconds.value_or(10); }
};

Result<film::FlowDesc> description(const SimulateCommand& command) {
  std::string text = "shabon: 1\nflow: {}\n", name = "<no file>";
  if (command.file) {
    Result<std::string> content = io::read_text_file(*command.file, io::yaml_max_bytes);
    if (!content) return content.errors();
    text = *std::move(content), name = *command.file;
  }
  std::vector<std::string> overrides;
  if (command.preset) overrides.push_back("flow.preset=" + *command.preset);
  overrides.insert(overrides.end(), command.overrides.begin(), command.overrides.end());
  return scene::read_flow(text, name, overrides);
}

Result<std::vector<const FrameKind*>> kinds_of(const std::vector<std::string>& texts) {
  std::vector<std::string_view> names;
  for (const FrameKind& kind : frame_kinds()) names.push_back(kind.name);
  std::vector<const FrameKind*> found;
  for (const std::string& text : texts)
    for (const std::string_view part : split(text, ',')) {
      const FrameKind* kind = nullptr;
      for (const FrameKind& candidate : frame_kinds())
        if (same_name(candidate.name, trim(part))) kind = &candidate;
      if (kind == nullptr) return fail(Failure::usage, "--write: " + unknown_name("kind", trim(part), names));
      if (std::find(found.begin(), found.end(), kind) == found.end()) found.push_back(kind);
    }
  return found;
}

// What the flags say, in place of what was set before.
Result<FlowSettings> settings_of(const SimulateCommand& command, FlowSettings settings) {
  if (!command.kinds.empty()) {
    const auto kinds = kinds_of(command.kinds);
    if (!kinds) return kinds.errors();
    settings.kinds = *kinds;
  }
  if (command.rate) settings.frames_per_second = *command.rate;
  if (command.checkpoint_every) settings.checkpoint_every = static_cast<int>(*command.checkpoint_every);
  if (command.lat_long_width) settings.maps.lat_long_width = static_cast<int>(*command.lat_long_width) / 2 * 2;
  if (command.cube_edge) settings.maps.cube_edge = static_cast<int>(*command.cube_edge);
  if (command.medium) {
    const auto medium = optics::parse_medium(*command.medium, api::medium_resolver());
    if (!medium) return medium.errors();
    settings.maps.refractive_index = std::round(medium->index(gltf_wavelength_nm).real() * 1e4) / 1e4;
  }
  if (command.png_range.size() == 2) {
    const bool any = std::any_of(settings.kinds.begin(), settings.kinds.end(),
                                 [](const FrameKind* kind) { return kind->name == "gltf"; });
    if (!any) return fail(Failure::usage, "--png-range: expected gltf in --write, as no other kind is a PNG");
    settings.maps.png_range_nm = {command.png_range[0], command.png_range[1]};
  }
  return settings;
}

// One simulation from its first frame to its last.
class Run {
 public:
  Run(const SimulateCommand& command, FlowFolder folder, film::FilmFlow flow, int frame,
      const InterruptGuard& interrupt)
      : command_(command),
        folder_(std::move(folder)),
        flow_(std::move(flow)),
        frame_(frame),
        first_(frame),
        interrupt_(interrupt),
        maps_(flow_, folder_.settings().maps),
        bar_(command.quiet, "simulating") {}

  // Writes the present frame, too, when it is the first.
  int go_on() {
    const double rate = folder_.settings().frames_per_second;
    const int last = static_cast<int>(std::floor(command_.seconds_asked() * rate + 1e-9));
    if (const auto why = film::why_dry_before(flow_.desc(), last / rate); why && frame_ < last) tell_dry(*why);
    Status done = frame_ == 0 ? write_frame(true) : Status(Done{});
    complete_ = frame_ > 0 || done;
    while (done && frame_ < last && !interrupt_.interrupted() && !flow_.rupture()) {
      done = step();
      bar_.update(double(frame_ - first_) / std::max(last - first_, 1));
    }
    bar_.finish();
    return finish(done);
  }

 private:
  // To the next frame. A stop on the way leaves the last one as it was.
  Status step() {
    checkpoint_ = flow_.checkpoint();
    flow_.begin_report();
    const Status advanced = flow_.advance_to((frame_ + 1) / folder_.settings().frames_per_second, &interrupt_.stop());
    if (!advanced || interrupt_.interrupted()) return advanced;
    ++frame_;
    const Status written = write_frame(frame_ % folder_.settings().checkpoint_every == 0);
    if (!written) {
      --frame_;
      return written;
    }
    checkpoint_.clear();
    if (const auto why = told_dry_ ? std::nullopt : film::why_dry(flow_)) tell_dry(*why);
    return written;
  }

  void tell_dry(const std::string& why) {
    bar_.finish();
    report({warning_of(why)});
    told_dry_ = true;
  }

  Status write_frame(bool with_checkpoint) {
    const io::Metadata metadata{{"Software", fmt::format("shabon {}", version())},
                                {"content", "thickness of a simulated soap film in nm"},
                                {"frame", std::to_string(frame_)},
                                {"time_s", format_number(flow_.time_s())}};
    for (const FrameKind* kind : folder_.settings().kinds) {
      const auto files = kind->files(flow_, maps_, frame_, metadata);
      if (!files) return files.errors();
      clipping_.add(*kind, flow_, folder_.settings().maps);
      for (const FrameFile& file : *files)
        if (const Status written = folder_.write(file.name, file.bytes); !written) return written;
    }
    if (with_checkpoint)
      if (const Status written = folder_.write_checkpoint(frame_, flow_.checkpoint()); !written) return written;
    return folder_.add_row(frame_, flow_.report());
  }

  // Keeps what is finished, and says how it ended.
  int finish(const Status& done) {
    int code = done ? success : report(done.errors());
    const std::vector<std::byte> last = checkpoint_.empty() ? flow_.checkpoint() : checkpoint_;
    const Status kept = complete_ ? folder_.write_checkpoint(frame_, last) : Status(Done{});
    if (!kept && done) code = report(kept.errors());
    const std::string place = printable(folder_.path().string());
    if (const auto broken = flow_.rupture(); broken && done) say(rupture_text(*broken));
    report(clipping_.warnings());
    if (!done || !kept || interrupt_.interrupted())
      say(how_far(place, code));
    else if (frame_ == first_ && first_ > 0)
      say(fmt::format("frame {} is there already; nothing is written", frame_));
    else if (!command_.quiet)
      say(fmt::format("wrote frames {} to {} in '{}'", first_ == 0 ? 0 : first_ + 1, frame_, place));
    return code == success && interrupt_.interrupted() ? interrupt_.exit_code() : code;
  }

  // What is there of a run that stopped.
  std::string how_far(const std::string& place, int code) const {
    if (!complete_) return fmt::format("no frame is complete in '{}'", place);
    const auto from = folder_.last_checkpoint();
    std::string text = fmt::format("frames 0 to {} are complete in '{}'", frame_, place);
    if (code == static_cast<int>(Failure::content)) return text;  // it would stop there again
    if (!from) return text + ", without a checkpoint to go on from";
    return text +
           (*from == frame_ ? "; --resume goes on from there" : fmt::format("; --resume goes on from frame {}", *from));
  }

  const SimulateCommand& command_;
  FlowFolder folder_;
  film::FilmFlow flow_;
  int frame_, first_;
  const InterruptGuard& interrupt_;
  FrameMaps maps_;
  PngClipping clipping_;
  ProgressBar bar_;
  bool told_dry_ = false, complete_ = false;  // complete: the first frame at least
  std::vector<std::byte> checkpoint_;         // of the last frame, while the next is on its way
};

int start_anew(const SimulateCommand& command) {
  FlowSettings usual;
  usual.kinds = {&frame_kinds()[0], &frame_kinds()[1]};
  SimulateCommand asked = command;
  if (!asked.medium) asked.medium = usual_medium;
  const auto settings = settings_of(asked, usual);
  if (!settings) return report(settings.errors());
  const InterruptGuard interrupt;
  const auto desc = description(command);
  if (!desc) return report(desc.errors());
  auto flow = film::FilmFlow::start(*desc);
  if (!flow) return report(flow.errors());
  const auto folder = FlowFolder::begin(*command.folder, *settings, *desc);
  if (!folder) return report(folder.errors());
  return Run(command, *folder, std::move(flow).value(), 0, interrupt).go_on();
}

int start_again(const SimulateCommand& command) {
  const InterruptGuard interrupt;
  Diagnostics warnings;
  auto folder = FlowFolder::reopen(*command.folder, warnings);
  if (!folder) return report(folder.errors());
  const auto settings = settings_of(command, folder->settings());
  if (!settings) return report(settings.errors());
  const auto wanted = command.resume_frame ? std::optional<int>(int(*command.resume_frame)) : std::nullopt;
  auto start = folder->latest(wanted, warnings);
  report(warnings);
  if (!start) return report(start.errors());
  if (const Status changed = folder->change(*settings); !changed) return report(changed.errors());
  if (!command.quiet) say(fmt::format("going on from frame {}", start->frame));
  return Run(command, std::move(folder).value(), std::move(start->flow), start->frame, interrupt).go_on();
}

int run_simulate(const SimulateCommand& command) {
  if (!command.folder) return report(fail(Failure::usage, "expected -o DIR, a folder for the frames; got none"));
  const bool describes = command.file || command.preset || !command.overrides.empty();
  if (command.goes_on() && (describes || command.rate))
    return report(fail(Failure::usage,
                       "--resume takes the film and its frames a second from the folder; expected no "
                       "FILM, --preset, --set or --fps beside it"));
  if (!command.goes_on() && !describes)
    return report(fail(Failure::usage, "expected a FILM file or --preset NAME; got neither"));
  if (command.png_range.size() == 2 && command.png_range[0] >= command.png_range[1])
    return report(fail(Failure::usage, "--png-range: expected the lower number first"));
  return command.goes_on() ? start_again(command) : start_anew(command);
}

}  // namespace

Action declare_simulate(CLI::App& app) {
  const auto command = std::make_shared<SimulateCommand>();
  add_text(app, "FILM", command->file, "", "File with a film: `shabon: 1` and `flow: {...}`");
  std::vector<std::string_view> presets = scene::flow_preset_names();
  app.add_option_function<std::string>(
         "--preset",
         [command, presets](const std::string& text) {
           if (std::find(presets.begin(), presets.end(), lower(text)) == presets.end())
             usage_error("--preset", unknown_name("preset", text, presets));
           command->preset = lower(text);
         },
         fmt::format("A film of the library: {}", fmt::join(presets, ", ")))
      ->type_name("NAME");
  add_texts(app, "--set", command->overrides, "PATH=VALUE", "Set a value of the film, such as flow.level=6");
  add_text(app, "-o,--output", command->folder, "DIR", "Folder for the frames, made where it is missing");
  add_number(app, "--seconds", command->seconds, seconds_range, "s", "Time to simulate, from the start [10]");
  add_number(app, "--fps", command->rate, rate_range, "1/s", "Frames a second of the film's time [25]");
  std::vector<std::string> told;
  for (const FrameKind& kind : frame_kinds()) told.push_back(fmt::format("{} ({})", kind.name, kind.content));
  add_texts(app, "--write", command->kinds, "KINDS",
            fmt::format("What each frame is written as: {} [lat-long,cube]", fmt::join(told, ", ")));
  constexpr long long most_side = 16384;
  add_integer(app, "--lat-long-width", command->lat_long_width, 16, most_side, "Pixels around the equator [1024]");
  add_integer(app, "--cube-edge", command->cube_edge, 2, most_side / 4, "Pixels along the edge of a face [256]");
  add_tuple(app, "--png-range", command->png_range, 2, "LOW HIGH",
            "Thickness in nm of black and white in the 16-bit PNG [that of each frame]");
  add_text(
      app, "--medium", command->medium, "MEDIUM",
      fmt::format("Liquid whose index stands in the glTF block: a name, an index or file:PATH [{}]", usual_medium));
  add_integer(app, "--checkpoint-every", command->checkpoint_every, 1, most_frames,
              "Frames from one checkpoint to the next; there is one of the last frame, too [10]");
  app.add_flag("--resume", command->resume, "Go on from the last frame in the folder");
  add_integer(app, "--resume-from", command->resume_frame, 0, most_frames,
              "Go on from this frame, or the last checkpoint before it; later frames are written again");
  app.add_flag("--quiet", command->quiet, "No progress; only warnings and errors");
  app.footer(
      R"(Simulates a soap film on a sphere: thickness, surfactant and flow (docs/living-film.md). The folder gets the frames,
diagnostics.csv with one row a frame, and checkpoints. An interrupted run keeps every finished frame, and the resumed
one makes the same numbers, bit by bit, as one that was never interrupted.

Examples:
  shabon simulate --preset fresh -o fresh --seconds 4
  shabon simulate film.yaml -o run --set flow.level=6 --write cube,ply
  shabon simulate -o run --resume --seconds 20)");
  return [command] { return run_simulate(*command); };
}

}  // namespace shabon::app
