#include "shabon/scene/thickness_text.h"

#include "shabon/scene/film_desc.h"
#include "shabon/scene/schema_build.h"
#include "shabon/scene/schema_fields.h"
#include "shabon/scene/textures.h"

namespace shabon::scene {

namespace {

film::ThicknessField field_at(const ThicknessDesc& thickness, double time_s, Textures& textures) {
  if (const auto model = thickness_model(thickness)) return film::at_time(*model, time_s);
  const Path root, map{&root, about(Of<ThicknessMapDesc>{}).name};
  const auto picture = textures.thickness_nm(std::get<ThicknessMapDesc>(thickness), time_s, map);
  if (const auto* flat = std::get_if<TexturePicture>(&picture))
    return film::LatitudeMap{flat->raster, flat->repeat_u, flat->repeat_v};
  return std::get<std::shared_ptr<const film::SphereMap>>(picture);
}

}  // namespace

Result<std::vector<film::ThicknessField>> read_thickness(std::string_view text, std::string source,
                                                         std::span<const double> times_s, const Resources& resources,
                                                         Diagnostics* warnings) {
  const Mapping& schema = mapping_of<ThicknessDesc>();
  Diagnostics flaws;
  const Result<io::YamlDocument> document = io::parse_yaml(text, std::move(source), flaws);
  if (!document) return document.errors();
  Problems problems(&*document);
  problems.adopt(flaws);
  ThicknessDesc thickness;
  const Path root;
  read_mapping(schema, document->root, root, &thickness, problems);
  check_mapping(schema, &thickness, root, problems);
  if (std::holds_alternative<FlowThicknessDesc>(thickness))
    problems.add(Path{&root, about(Of<FlowThicknessDesc>{}).name},
                 "expected a thickness model or a map; a simulated film has to run first, and its pictures are a map");
  if (!problems.empty()) return problems.errors();
  Textures textures(resources, problems);
  std::vector<film::ThicknessField> fields;
  for (const double time_s : times_s) {
    fields.push_back(field_at(thickness, time_s, textures));
    if (!problems.empty()) return problems.errors();
  }
  if (warnings != nullptr)
    for (Diagnostic& warning : problems.warnings()) warnings->push_back(std::move(warning));
  return fields;
}

}  // namespace shabon::scene
