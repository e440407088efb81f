#include "shabon/api/resources.h"

#include <utility>

#include "shabon/api/reflectance_file.h"
#include "shabon/api/resolvers.h"
#include "shabon/api/texture_file.h"
#include "shabon/io/image.h"

namespace shabon::api {

scene::Resources file_resources(const std::filesystem::path& folder,
                                std::function<void(const std::filesystem::path&)> opened) {
  const auto tell = [opened = std::move(opened)](const std::filesystem::path& path) {
    if (opened) opened(path);
  };
  scene::Resources resources;
  resources.medium = [folder, tell, resolve = medium_resolver(folder)](std::string_view name_or_file, bool is_file) {
    if (is_file) tell(folder / std::filesystem::path(name_or_file));
    return resolve(name_or_file, is_file);
  };
  resources.illuminant = [folder, tell, resolve = illuminant_resolver(folder)](std::string_view text) {
    if (const auto file = color::illuminant_file(text)) tell(folder / *file);
    return resolve(text);
  };
  resources.picture = [folder, tell](const std::string& file) {
    tell(folder / file);
    return io::read_image(folder / file);
  };
  resources.texture = [folder, tell](const std::string& file) {
    tell(folder / file);
    return read_texture(folder / file);
  };
  resources.reflectance = [folder, tell](const std::string& file) {
    tell(folder / file);
    return read_reflectance_file(folder / file);
  };
  return resources;
}

}  // namespace shabon::api
