// A simulated film as a scene file states it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "shabon/film/flow/parameters.h"
#include "shabon/film/flow/presets.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"

namespace shabon::scene {

// The other keys have the preset's values where they are not given.
struct FlowThicknessDesc : film::FlowDesc {
  std::optional<std::string> preset;
};

inline std::vector<std::string_view> flow_preset_names() {
  std::vector<std::string_view> names;
  for (const film::FlowPreset& preset : film::flow_presets()) names.push_back(preset.name);
  return names;
}

constexpr std::string_view section(Of<FlowThicknessDesc>) { return "flow"; }
constexpr About about(Of<FlowThicknessDesc>) {
  return {.name = "flow", .doc = "A simulated soap film that flows, drains and turns black; on a bubble only."};
}
constexpr auto fields(Of<FlowThicknessDesc>) {
  constexpr FieldInfo preset{.names = flow_preset_names, .doc = "where the keys that are not given come from"};
  return std::tuple_cat(std::tuple{Field{"preset", &FlowThicknessDesc::preset, preset}},
                        film::fields(Of<film::FlowDesc>{}));
}

// Fills `flow` with the preset that the mapping names, before its other keys are read.
void begin(const io::YamlNode& mapping, FlowThicknessDesc& flow);
void check(const FlowThicknessDesc& flow, const Path& path, Problems& problems);

}  // namespace shabon::scene
