// shabon render: text -> SceneDesc -> compile -> Scene -> render -> Sensor -> develop -> picture -> file.
#include "shabon/render/render.h"

#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "film_news.h"
#include "interrupt.h"
#include "options.h"
#include "picture_files.h"
#include "progress_bar.h"
#include "render_report.h"
#include "scene_input.h"
#include "shabon/io/file.h"
#include "shabon/scene/running_films.h"
#include "shabon/scene/schema_fields.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr const char* built_in_picture = "bubble.png";
constexpr long long most_threads = 1024;

struct RenderCommand {
  SceneInput scene;
  std::vector<std::string> outputs;
  std::optional<long long> threads;
  std::optional<double> exposure_ev;
  std::optional<std::string> stats;
  bool quiet = false;

  std::vector<std::string> output_names() const {
    if (!outputs.empty()) return outputs;
    if (!scene.file) return {built_in_picture};
    return {std::filesystem::path(*scene.file).stem().string() + ".png"};
  }
};

// Everything that can be known to fail before the first ray.
Status check_files(const RenderCommand& command, const std::vector<PictureFile>& pictures, const LoadedScene& loaded) {
  std::vector<std::filesystem::path> outputs;
  outputs.reserve(pictures.size() + 1);
  for (const PictureFile& picture : pictures) outputs.push_back(picture.path);
  if (command.stats) outputs.emplace_back(*command.stats);
  return check_outputs(outputs, loaded.files_read);
}

// Writes what it can: a file that fails costs no other, least of all a picture. The exit code of the first failure.
int write_outputs(const RenderCommand& command, const std::vector<PictureFile>& pictures, const LoadedScene& loaded,
                  const render::RenderReport& done, const render::Sensor& sensor) {
  int code = success;
  std::vector<std::string> kept;
  const auto note = [&](const std::filesystem::path& path, const Status& written, const std::string& what) {
    if (!written) {
      const int failed = report(written.errors());
      code = code == success ? failed : code;
      return;
    }
    kept.push_back(printable(path.string()));
    if (!command.quiet) say(fmt::format("wrote {}{}", kept.back(), what));
  };
  const io::Metadata metadata = picture_metadata(loaded, command.scene.overrides, done);
  scene::Development development = loaded.scene.development;
  development.exposure_ev += command.exposure_ev.value_or(0);
  const std::string size = fmt::format(": {} x {}, {} samples a pixel, {:.1f} s", sensor.width(), sensor.height(),
                                       done.samples_done, done.seconds);
  for (const PictureFile& picture : pictures)
    note(picture.path, picture.kind->write(picture.path, sensor, development, metadata), size);
  if (command.stats) note(*command.stats, io::write_file_atomically(*command.stats, stats_json(loaded, done)), "");
  if (code != success && !kept.empty()) say(fmt::format("complete in spite of this: {}", fmt::join(kept, ", ")));
  return code;
}

Status run_films(scene::Scene& scene, bool quiet, const StopFlag& stop) {
  auto films = scene::RunningFilms::start(scene);
  if (!films) return films.errors();
  report(films->forecast(scene.time_s));
  ProgressBar bar(quiet, "simulating");
  const Status done = films->advance_to(scene.time_s, &stop, [&bar](double share) { bar.update(share); });
  bar.finish();
  report(films->news());
  if (!done) return done;
  if (const auto broken = films->rupture()) say(rupture_text(*broken));
  films->show_in(scene);
  return Done{};
}

int run_render(const RenderCommand& command) {
  const auto pictures = picture_files(command.output_names());
  if (!pictures) return report(pictures.errors());
  const InterruptGuard interrupt;

  Result<LoadedScene> loaded = load(command.scene);
  if (!loaded) return report(loaded.errors());
  const Status checked = check_files(command, *pictures, *loaded);
  if (!checked) return report(checked.errors());

  const Status ran = run_films(loaded->scene, command.quiet, interrupt.stop());
  if (!ran) return report(ran.errors());
  ProgressBar bar(command.quiet);
  render::RenderOptions options;
  options.threads = static_cast<int>(command.threads.value_or(0));
  options.progress = [&bar](double done) { bar.update(done); };
  options.stop = &interrupt.stop();
  render::Sensor sensor(loaded->scene.width, loaded->scene.height);
  const Result<render::RenderReport> done = render::render(loaded->scene, options, sensor);
  bar.finish();
  if (!done) return report(done.errors());

  if (done->interrupted && done->camera_samples == 0) {
    say("interrupted before anything was finished; nothing is written");
    return interrupt.exit_code();
  }
  report(render_warnings(*done, sensor));
  if (done->interrupted) say(interruption_message(sensor));
  const int code = write_outputs(command, *pictures, *loaded, *done, sensor);
  return code == success && done->interrupted ? interrupt.exit_code() : code;
}

}  // namespace

Action declare_render(CLI::App& app) {
  const auto command = std::make_shared<RenderCommand>();
  add_scene_input(app, command->scene);
  add_texts(app, "-o,--output", command->outputs, "FILE",
            "Picture to write, .png or .exr; may be repeated [bubble.png, or the scene's name with .png]");
  add_scene_integer(app, command->scene, "--samples", "render.samples", scene::samples_range, "Camera samples a pixel");
  add_scene_integer(app, command->scene, "--seed", "render.seed", scene::seed_range, "Start of the random numbers");
  add_scene_name(app, command->scene, "--transport", "render.transport", scene::transport_names(),
                 "How paths are followed");
  add_integer(app, "--threads", command->threads, 1, most_threads, "Threads; never changes the picture [one a core]");
  add_number(app, "--exposure", command->exposure_ev, scene::exposure_range, "EV",
             "Brightens PNG pictures by 2^EV, on top of image.exposure_ev [0]");
  add_text(app, "--stats", command->stats, "FILE.json", "Writes what was done, and how fast");
  app.add_flag("--quiet", command->quiet, "No progress; only warnings and errors");
  app.footer(
      R"(PNG is sRGB; colours outside it are mapped into it, keeping hue and lightness. EXR is linear sRGB, unclipped,
without exposure and white balance. Flags win over --set, and --set over the file. An interrupted render (Ctrl-C) writes what it has.
When one of several files cannot be written, the others still are, and the exit code is 4.

Examples:
  shabon render
  shabon render scenes/bubble/scene.yaml -o bubble.png -o bubble.exr --samples 256
  shabon render --size 1920x1080 --exposure -0.5 --set objects[0].bubble.film.medium=1.4
  shabon render scenes/bubble/scene.yaml --interference two-beam --stats stats.json)");
  return [command] { return run_render(*command); };
}

}  // namespace shabon::app
