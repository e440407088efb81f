#include "shabon/api/nk_file.h"

#include "shabon/api/nk_csv.h"
#include "shabon/api/nk_yaml.h"
#include "shabon/base/text.h"

namespace shabon::api {

Result<optics::Medium> read_nk_file(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  Result<optics::Medium> medium = ending == ".yml" || ending == ".yaml" ? read_nk_yaml(path) : read_nk_csv(path);
  if (medium) return medium;
  // Errors about the values as a whole know no place; the file is one.
  Diagnostics errors = medium.errors();
  for (Diagnostic& error : errors)
    if (error.source.empty()) error.source = path.string();
  return errors;
}

}  // namespace shabon::api
