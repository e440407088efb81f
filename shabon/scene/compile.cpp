#include "shabon/scene/compile.h"

#include <algorithm>
#include <new>

#include "shabon/base/text.h"
#include "shabon/scene/bubble_motion.h"
#include "shabon/scene/compile_camera.h"
#include "shabon/scene/compile_environment.h"
#include "shabon/scene/compile_objects.h"
#include "shabon/scene/override.h"
#include "shabon/scene/scene_file.h"
#include "shabon/scene/schema_fields.h"

namespace shabon::scene {

namespace {

RenderSettings compile_settings(const RenderDesc& render) {
  RenderSettings settings;
  settings.samples = render.samples;
  settings.seed = render.seed;
  settings.interference = render.interference;
  settings.split_threshold = render.split_threshold;
  settings.max_depth = render.max_depth;
  settings.transport = same_name(render.transport, "path") ? Transport::path : Transport::tree;
  return settings;
}

// Whether there is any light at all.
bool shines(const ConstantLight& light) { return light.scale > 0; }
bool shines(const GradientLight& light) { return light.up_scale > 0 || light.down_scale > 0; }
bool shines(const ImageLight& light) {
  const std::vector<float>& texels = light.picture->texels;
  return light.scale > 0 && std::any_of(texels.begin(), texels.end(), [](float v) { return v > 0; });
}
bool shines(const SkyLight& light) { return light.luminance.factor > 0; }
bool shines(const Scene& scene) {
  if (std::visit([](const auto& light) { return shines(light); }, scene.environment.base)) return true;
  for (const Softbox& softbox : scene.environment.softboxes)
    if (std::visit([](const auto& light) { return light.scale > 0; }, softbox)) return true;
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [](const Surface& surface) {
    const auto* emitter = std::get_if<EmitterSurface>(&surface);
    return emitter != nullptr && emitter->scale > 0;
  });
}

// `problems` may hold what reading found: then the rest is added and there is no scene.
Result<Scene> compile_with(const SceneDesc& description, const Resources& resources, CameraUse camera,
                           Problems& problems) {
  const Path root;
  check_mapping(scene_schema(), &description, root, problems);
  Scene scene;
  scene.render = compile_settings(description.render);
  scene.metres_per_unit = description.metres_per_unit;
  scene.time_s = description.time_s;
  const Path environment{&root, "environment"}, objects{&root, "objects"};
  scene.development = compile_development(description.image, Path{&root, "image"}, resources, problems);
  LampChannels lamps(resources, problems);
  scene.environment = compile_environment(description.environment, environment, resources, lamps, problems);
  SceneMedia media(problems);
  SurfaceCompiler surfaces(scene, lamps, media, resources, problems);
  ObjectsCompiler compiler(scene, surfaces, problems);
  for (std::size_t i = 0; i < description.objects.size() && !problems.full(); ++i) {
    const int index = static_cast<int>(i);
    compiler.add(description.objects[i], Path{&objects, {}, index}, index);
  }
  scene.medium = media.settle();
  compiler.finish(description.objects, objects);
  if (camera == CameraUse::takes_pictures)
    compiler.check_camera(description.objects, objects, description.camera.position);
  if (!problems.empty()) return problems.errors();
  add_rims(scene);
  scene.environment.channels = std::move(lamps.spectra);
  if (!shines(scene))
    problems.add_warning(environment,
                         "nothing shines in this scene: every lamp is off or black, and so is the picture");
  scene.width = description.image.width;
  scene.height = description.image.height;
  scene.camera = compile_camera(description.camera, description.image);
  scene.filter = compile_filter(description.image);
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

Result<Scene> compile(const SceneDesc& description, const Resources& resources, Diagnostics* warnings,
                      CameraUse camera) {
  Problems problems(description.origin.get());
  return within_memory(problems, warnings, [&] { return compile_with(description, resources, camera, problems); });
}

Result<Scene> load_scene(std::string_view text, std::string source, std::span<const std::string> overrides,
                         const Resources& resources, Diagnostics* warnings, CameraUse camera) {
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
    return compile_with(description, resources, camera, problems);
  });
}

}  // namespace shabon::scene
