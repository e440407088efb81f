#include "shabon/scene/flow_file.h"

#include "shabon/scene/override.h"
#include "shabon/scene/schema_build.h"

namespace shabon::scene {

Result<film::FlowDesc> read_flow(std::string_view text, std::string source, std::span<const std::string> overrides) {
  const Mapping& schema = mapping_of<FlowFileDesc>();
  Diagnostics flaws;
  Result<io::YamlDocument> document = io::parse_yaml(text, std::move(source), flaws);
  if (!document) return document.errors();
  for (const std::string& assignment : overrides)
    if (const Status set = apply_override(*document, assignment, schema); !set)
      flaws.insert(flaws.end(), set.errors().begin(), set.errors().end());
  Problems problems(&*document);
  problems.adopt(flaws);
  FlowFileDesc file;
  const Path root;
  read_mapping(schema, document->root, root, &file, problems);
  check_mapping(schema, &file, root, problems);
  if (!problems.empty()) return problems.errors();
  return film::FlowDesc(file.flow);
}

}  // namespace shabon::scene
