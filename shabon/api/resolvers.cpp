#include "shabon/api/resolvers.h"

#include <utility>

#include "shabon/api/lamp_file.h"
#include "shabon/api/nk_file.h"
#include "shabon/optics/media.h"

namespace shabon::api {

optics::MediumResolver medium_resolver(std::filesystem::path folder) {
  return [folder = std::move(folder)](std::string_view name_or_file, bool is_file) -> Result<optics::Medium> {
    if (!is_file) return optics::medium_named(name_or_file);
    return read_nk_file(folder / std::filesystem::path(name_or_file));
  };
}

std::function<Result<color::Illuminant>(std::string_view)> illuminant_resolver(std::filesystem::path folder) {
  return [folder = std::move(folder)](std::string_view text) -> Result<color::Illuminant> {
    const std::optional<std::string> file = color::illuminant_file(text);
    if (!file) return color::illuminant_named(text);
    return read_lamp_file(folder / *file);
  };
}

}  // namespace shabon::api
