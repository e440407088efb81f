#include "shabon/scene/compile.h"

#include <array>
#include <map>
#include <new>

#include "shabon/base/units.h"
#include "shabon/color/spectrum.h"
#include "shabon/scene/compile_environment.h"
#include "shabon/scene/film_parts.h"
#include "shabon/scene/override.h"
#include "shabon/scene/scene_file.h"
#include "shabon/scene/schema_fields.h"

namespace shabon::scene {

namespace {

double radians(double degrees) { return Radians(Degrees(degrees)).value; }

Camera compile_camera(const CameraDesc& camera, const ImageDesc& image) {
  Camera result = look_at_camera(camera.position, camera.look_at, camera.up, radians(camera.vertical_fov_deg),
                                 image.width, image.height);
  if (camera.polarizer_deg) result.polarizer_rad = radians(*camera.polarizer_deg);
  return result;
}

RenderSettings compile_settings(const RenderDesc& render) {
  RenderSettings settings;
  settings.samples = render.samples;
  settings.seed = render.seed;
  settings.interference = render.interference;
  settings.split_threshold = render.split_threshold;
  settings.max_depth = render.max_depth;
  return settings;
}

// Spheres, their films, and the one medium that all of them float in.
class ObjectsCompiler {
 public:
  ObjectsCompiler(Scene& scene, const Resources& resources, Problems& problems)
      : scene_(scene), resources_(resources), problems_(problems) {}

  void add(const BubbleDesc& bubble, const Path& object) {
    const Path path{&object, about(Of<BubbleDesc>{}).name};
    const Path film{&path, "film"};
    const auto parts = std::visit(
        [&](const auto& chosen) { return film_parts(chosen, film, resources_.medium, problems_); }, bubble.film);
    if (!parts) return;
    check_outer_media(*parts, film, problems_);
    check_model(*parts, scene_.render.interference, film, problems_);
    settle_medium(*parts, film);
    warn_outside_range(parts->outside, film);
    for (const optics::Layer& layer : parts->film.layers) warn_outside_range(layer.medium, film);
    // -0 + 0 = 0: the two zeros are one place.
    const std::array<double, 4> key = {bubble.center.x + 0.0, bubble.center.y + 0.0, bubble.center.z + 0.0,
                                       bubble.radius};
    const auto [entry, added] = place_.try_emplace(key, spheres_.size());
    if (added) spheres_.push_back({{bubble.center, bubble.radius, 0, 0}, {}});
    spheres_[entry->second].films.push_back(parts->film);
  }

  void finish() {
    for (SphereInProgress& sphere : spheres_) {
      sphere.sphere.first_film = static_cast<int>(scene_.films.size());
      sphere.sphere.film_count = static_cast<int>(sphere.films.size());
      scene_.spheres.push_back(sphere.sphere);
      for (Film& film : sphere.films) scene_.films.push_back(std::move(film));
    }
  }

 private:
  struct SphereInProgress {
    Sphere sphere;
    std::vector<Film> films;  // of every object with this centre and radius, outermost first
  };

  void settle_medium(const FilmParts& parts, const Path& film) {
    if (!medium_settled_) {
      scene_.medium = parts.outside;
      medium_settled_ = true;
      settled_by_ = film.text();
    } else if (!(scene_.medium == parts.outside) && !problems_.has(film)) {
      const Path stack{&film, "stack"};
      problems_.add(stack, "expected the outer medium '" + scene_.medium.name() + "' of " + settled_by_ + ", got '" +
                               parts.outside.name() + "'; all bubbles of a scene float in one medium");
    }
  }

  void warn_outside_range(const optics::Medium& medium, const Path& film) {
    const std::string note = medium.outside_range_note(optics::WavelengthRange{color::first_nm, color::last_nm});
    if (note.empty()) return;
    for (const std::string& name : warned_)
      if (name == medium.name()) return;
    warned_.push_back(medium.name());
    problems_.add_warning(film, note);
  }

  Scene& scene_;
  const Resources& resources_;
  Problems& problems_;
  std::vector<SphereInProgress> spheres_;
  std::map<std::array<double, 4>, std::size_t> place_;
  bool medium_settled_ = false;
  std::string settled_by_;
  std::vector<std::string> warned_;
};

// `problems` may hold what reading found: then the rest is added and there is no scene.
Result<Scene> compile_with(const SceneDesc& description, const Resources& resources, Problems& problems) {
  const Path root;
  check_mapping(scene_schema(), &description, root, problems);
  Scene scene;
  scene.render = compile_settings(description.render);
  const Path environment{&root, "environment"}, objects{&root, "objects"};
  scene.environment = compile_environment(description.environment, environment, resources, problems);
  ObjectsCompiler compiler(scene, resources, problems);
  for (std::size_t i = 0; i < description.objects.size() && !problems.full(); ++i) {
    const Path path{&objects, {}, static_cast<int>(i)};
    std::visit([&](const auto& object) { compiler.add(object, path); }, description.objects[i]);
  }
  if (!problems.empty()) return problems.errors();
  compiler.finish();
  scene.width = description.image.width;
  scene.height = description.image.height;
  scene.camera = compile_camera(description.camera, description.image);
  return scene;
}

// Runs `work`, which returns a scene and fills `problems`.
template <class Work>
Result<Scene> within_memory(Problems& problems, Diagnostics* warnings, const Work& work) {
  try {
    Result<Scene> scene = work();
    if (warnings != nullptr)
      for (Diagnostic& warning : problems.warnings()) warnings->push_back(std::move(warning));
    return scene;
  } catch (const std::bad_alloc&) {
    return fail(Failure::internal, "the scene does not fit into memory");
  }
}

}  // namespace

Result<Scene> compile(const SceneDesc& description, const Resources& resources, Diagnostics* warnings) {
  Problems problems(description.origin.get());
  return within_memory(problems, warnings, [&] { return compile_with(description, resources, problems); });
}

Result<Scene> load_scene(std::string_view text, std::string source, std::span<const std::string> overrides,
                         const Resources& resources, Diagnostics* warnings) {
  Diagnostics flaws;
  Result<io::YamlDocument> document = io::parse_yaml(text, std::move(source), flaws);
  if (!document) return document.errors();
  for (const std::string& assignment : overrides)
    if (const Status set = apply_override(*document, assignment); !set)
      flaws.insert(flaws.end(), set.errors().begin(), set.errors().end());
  const auto shared = std::make_shared<const io::YamlDocument>(*std::move(document));
  Problems problems(shared.get());
  problems.adopt(flaws);
  return within_memory(problems, warnings, [&] {
    const SceneDesc description = read_description(shared, problems);
    return compile_with(description, resources, problems);
  });
}

}  // namespace shabon::scene
