// A simulated film as a file of its own.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "shabon/base/result.h"
#include "shabon/scene/flow_desc.h"
#include "shabon/scene/schema_fields.h"

namespace shabon::scene {

struct FlowFileDesc {
  int shabon = scene_file_version;
  FlowThicknessDesc flow;
};

constexpr auto fields(Of<FlowFileDesc>) {
  constexpr FieldInfo version{.range = version_range, .required = true, .doc = "version of the format"};
  return std::tuple{Field{"shabon", &FlowFileDesc::shabon, version},
                    Field{"flow", &FlowFileDesc::flow, {.required = true, .doc = "the simulated film"}}};
}

// The text of a file that holds a film alone (`shabon: 1` and `flow: {...}`), after `overrides` ("flow.level=6").
// Errors (Failure::content): everything that is wrong, each at its place.
Result<film::FlowDesc> read_flow(std::string_view text, std::string source, std::span<const std::string> overrides);

}  // namespace shabon::scene
