#include "shabon/scene/scene_file.h"

#include "shabon/scene/schema.h"

namespace shabon::scene {

namespace {

Result<SceneDesc> read_with_flaws(io::YamlDocument document, const Diagnostics& flaws, Diagnostics* warnings) {
  const auto shared = std::make_shared<const io::YamlDocument>(std::move(document));
  Problems problems(shared.get());
  problems.adopt(flaws);
  SceneDesc description = read_description(shared, problems);
  check_mapping(scene_schema(), &description, Path{}, problems);
  if (warnings != nullptr)
    for (Diagnostic& warning : problems.warnings()) warnings->push_back(std::move(warning));
  if (!problems.empty()) return problems.errors();
  return description;
}

}  // namespace

SceneDesc read_description(const std::shared_ptr<const io::YamlDocument>& document, Problems& problems) {
  SceneDesc description;
  description.origin = document;
  const Path root;
  read_mapping(scene_schema(), document->root, root, &description, problems);
  return description;
}

Result<SceneDesc> read_scene(io::YamlDocument document, Diagnostics* warnings) {
  return read_with_flaws(std::move(document), {}, warnings);
}

Result<SceneDesc> read_scene(std::string_view text, std::string source, Diagnostics* warnings) {
  Diagnostics flaws;
  Result<io::YamlDocument> document = io::parse_yaml(text, std::move(source), flaws);
  if (!document) return document.errors();
  return read_with_flaws(*std::move(document), flaws, warnings);
}

}  // namespace shabon::scene
