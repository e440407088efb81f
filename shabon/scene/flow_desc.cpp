#include "shabon/scene/flow_desc.h"

#include "shabon/base/text.h"

namespace shabon::scene {

void begin(const io::YamlNode& mapping, FlowThicknessDesc& flow) {
  for (const auto& [name, value] : mapping.entries) {
    if (name.text != "preset" || value.kind != io::YamlNode::Kind::scalar) continue;
    if (const auto* preset = film::flow_preset(value.text)) static_cast<film::FlowDesc&>(flow) = preset->desc;
  }
}

void check(const FlowThicknessDesc& flow, const Path& path, Problems& problems) {
  for (const Diagnostic& flaw : film::check(flow)) {
    const std::vector<std::string_view> keys = split(flaw.key, '.');  // one or two
    const Path first{&path, keys.front()}, second{&first, keys.back()};
    const Path& at = keys.size() > 1 ? second : first;
    if (!problems.has(at)) problems.add(at, flaw.message);
  }
}

}  // namespace shabon::scene
