// shabon probe: the spectrum that arrives along one exact ray.
#include "shabon/render/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "command.h"
#include "json.h"
#include "options.h"
#include "scene_input.h"
#include "shabon/base/text.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"
#include "shabon/scene/object_at.h"
#include "shabon/scene/running_films.h"
#include "streams.h"
#include "wavelengths.h"

namespace shabon::app {

namespace {

constexpr double least_told_cut = 1e-6;  // share of the light
constexpr long long most_samples = 1'000'000'000;

struct ProbeCommand {
  SceneInput scene;
  std::vector<double> pixel, ray;
  std::vector<double> wavelengths_nm;
  std::size_t format = 0;
  std::optional<long long> samples;
};

struct ProbedSpectrum {
  std::vector<double> wavelengths_nm, radiance;
  std::vector<double> standard_error;  // empty where nothing was left to chance
  color::Xyz xyz;                      // only for formats that show it
};

std::string probe_csv(const ProbedSpectrum& probed) {
  const bool by_chance = !probed.standard_error.empty();
  std::string csv = by_chance ? "wavelength_nm,radiance,standard_error\n" : "wavelength_nm,radiance\n";
  for (std::size_t i = 0; i < probed.radiance.size(); ++i) {
    csv += format_number(probed.wavelengths_nm[i]) + "," + format_exact(probed.radiance[i]);
    if (by_chance) csv += "," + format_exact(probed.standard_error[i]);
    csv += "\n";
  }
  return csv;
}

std::string probe_json(const ProbedSpectrum& probed) {
  const color::LinearRgb rgb = color::xyz_to_linear_srgb(probed.xyz);
  JsonObject json;
  json.add("wavelength_nm", probed.wavelengths_nm).add("radiance", probed.radiance);
  if (!probed.standard_error.empty()) json.add("standard_error", probed.standard_error);
  json.add("XYZ", {probed.xyz.x, probed.xyz.y, probed.xyz.z}).add("linear_srgb", {rgb.r, rgb.g, rgb.b});
  return json.text();
}

struct Format {
  std::string_view name;
  std::string (*write)(const ProbedSpectrum&);
  bool shows_color;  // then the observer's 471 wavelengths are followed too
};

constexpr Format formats[] = {{"csv", probe_csv, false}, {"json", probe_json, true}};

// The ray that the flags name. Errors: a pixel outside the picture, a direction without length.
Result<render::ProbeRay> chosen_ray(const ProbeCommand& command, const scene::Scene& scene) {
  if (command.pixel.empty()) {
    const std::vector<double>& r = command.ray;
    // Scaled first: the square of a long direction would not fit.
    const double longest = std::max({std::abs(r[3]), std::abs(r[4]), std::abs(r[5])});
    if (longest == 0) return fail(Failure::usage, "--ray: expected a direction that is not 0 0 0");
    render::ProbeRay ray;
    ray.origin = {r[0], r[1], r[2]};
    if (const auto at = scene::object_at(scene, ray.origin))
      return fail(Failure::usage,
                  fmt::format("--ray: expected an origin off every surface, got one on objects[{}]", *at));
    ray.direction = {r[3] / longest, r[4] / longest, r[5] / longest};
    return ray;
  }
  // Fractions name points within a pixel; whole numbers its centre.
  const double x = command.pixel[0], y = command.pixel[1];
  const double right = scene.width - 0.5, bottom = scene.height - 0.5;
  if (!(x >= -0.5 && x <= right && y >= -0.5 && y <= bottom))
    return fail(Failure::usage,
                fmt::format("--pixel: expected X from -0.5 to {} and Y from -0.5 to {}, got {} {}",
                            format_number(right), format_number(bottom), format_number(x), format_number(y)));
  return render::pixel_ray(scene, x + 0.5, y + 0.5);
}

// The asked wavelengths, followed by those of the observer where the colour is wanted: all of them in one tree.
std::vector<double> traced_wavelengths_nm(const ProbeCommand& command) {
  std::vector<double> wavelengths_nm = command.wavelengths_nm;
  if (formats[command.format].shows_color)
    for (std::size_t i = 0; i < color::spectrum_size; ++i) wavelengths_nm.push_back(color::wavelength_nm(i));
  return wavelengths_nm;
}

// What was traced as what is shown.
ProbedSpectrum shown(const ProbeCommand& command, render::ProbeResult result) {
  ProbedSpectrum probed{command.wavelengths_nm, std::move(result.radiance), std::move(result.standard_error), {}};
  const std::size_t asked = command.wavelengths_nm.size();
  if (formats[command.format].shows_color) {
    color::Spectrum spectrum;
    std::copy(probed.radiance.begin() + static_cast<std::ptrdiff_t>(asked), probed.radiance.end(), spectrum.begin());
    probed.xyz = color::radiance_to_xyz(spectrum);
  }
  probed.radiance.resize(asked);
  if (!probed.standard_error.empty()) probed.standard_error.resize(asked);
  return probed;
}

// One line when the tree was cut so early that it can be seen in the numbers.
void tell_cut(const render::ProbeResult& result) {
  if (!(result.cut_carried > least_told_cut)) return;
  say(fmt::format(
      "note: not every reflection was followed: branches that carry less than {} of the light were cut, and up "
      "to {} of the light passed straight on where it should have been reflected",
      format_number(result.least_carried), format_number(result.cut_carried, 2)));
}

int run_probe(const ProbeCommand& command) {
  if (command.pixel.empty() && command.ray.empty())
    return report(fail(Failure::usage, "expected --pixel X Y or --ray OX OY OZ DX DY DZ"));
  const auto camera = command.ray.empty() ? scene::CameraUse::takes_pictures : scene::CameraUse::none;
  Result<LoadedScene> loaded = load(command.scene, camera);
  if (!loaded) return report(loaded.errors());
  if (const Status ran = scene::run_films(loaded->scene); !ran) return report(ran.errors());
  const Result<render::ProbeRay> ray = chosen_ray(command, loaded->scene);
  if (!ray) return report(ray.errors());

  render::ProbeOptions options;
  if (command.samples) options.samples = static_cast<std::size_t>(*command.samples);
  options.seed = loaded->scene.render.seed;
  const Result<render::ProbeResult> result =
      render::probe(loaded->scene, *ray, traced_wavelengths_nm(command), options);
  if (!result) return report(result.errors());
  tell_cut(*result);
  return print_result(formats[command.format].write(shown(command, *result)));
}

}  // namespace

Action declare_probe(CLI::App& app) {
  const auto command = std::make_shared<ProbeCommand>();
  add_scene_input(app, command->scene);
  CLI::Option* pixel = add_tuple(app, "--pixel", command->pixel, 2, "X Y",
                                 "Through the centre of pixel X Y, counted from 0 0 at the top left");
  add_tuple(app, "--ray", command->ray, 6, "OX OY OZ DX DY DZ", "From a point in a direction; no polariser")
      ->excludes(pixel);
  add_wavelengths(app, command->wavelengths_nm, "380:780:5", {.low = color::first_nm, .high = color::last_nm});
  add_integer(app, "--samples", command->samples, 1, most_samples,
              "Walks a wavelength where chance is needed; the error falls with their root [4096]");
  add_choice(app, "--format", command->format, formats, "Form of the output");
  app.footer(
      R"(Radiance is per nm, scaled so that its sum with the observer's ybar over 360..830 nm at 1 nm is Y; a lamp of scale 1
seen directly has Y = 1. Bubbles alone need no random numbers; in a scene with surfaces the radiance is a mean with its
standard error. XYZ and linear_srgb of the JSON are sums over that whole range.
X may have fractions, from -0.5 at the left edge to W-0.5 at the right; Y likewise, from the top edge to the bottom.

Examples:
  shabon probe --pixel 400 300
  shabon probe scenes/bubble/scene.yaml --pixel 400 120 --format json
  shabon probe scenes/bubble/scene.yaml --ray 0 0 5 0 -.1 -1 --wavelengths 400:700:10)");
  return [command] { return run_probe(*command); };
}

}  // namespace shabon::app
