#include "shabon/scene/textures.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/color/rgb.h"
#include "shabon/scene/frames.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

bool well_formed(const math::Raster& raster) {
  if (raster.width < 1 || raster.height < 1 || (raster.channels != 1 && raster.channels != 3)) return false;
  const std::size_t texels = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
  if (raster.values.size() != texels * static_cast<std::size_t>(raster.channels)) return false;
  return std::all_of(raster.values.begin(), raster.values.end(), [](float v) { return std::isfinite(v); });
}

std::string pixel_text(const math::Raster& raster, std::size_t texel) {
  const auto width = static_cast<std::size_t>(raster.width);
  return "pixel (" + std::to_string(texel % width) + ", " + std::to_string(texel / width) + ")";
}

std::string size_text(const math::Raster& raster) {
  return std::to_string(raster.width) + " x " + std::to_string(raster.height) + " pixels";
}

// Of one channel each.
std::shared_ptr<const math::Raster> mixture(const math::Raster& a, const math::Raster& b, double share) {
  auto result = std::make_shared<math::Raster>(a);
  for (std::size_t i = 0; i < a.values.size(); ++i)
    result->values[i] = static_cast<float>(a.values[i] + share * (double(b.values[i]) - a.values[i]));
  return result;
}

}  // namespace

const TextureFile* Textures::file(const std::string& name, const Path& map) {
  const Path place{&map, "file"};
  if (problems_.has(place)) return nullptr;
  auto entry = files_.find(name);
  const bool added = entry == files_.end();
  if (added) entry = files_.emplace(name, resources_.texture(name)).first;
  const Result<TextureFile>& loaded = entry->second;
  if (!loaded) {
    for (const Diagnostic& error : loaded.errors()) problems_.add_from_file(place, error);
    return nullptr;
  }
  if (added && loaded->negatives > 0)
    problems_.add_warning(place, std::to_string(loaded->negatives) + " negative values of the picture became 0");
  if (well_formed(loaded->raster)) return &*loaded;
  problems_.add(place, "expected a picture of one or three channels of finite values, got one that is not");
  return nullptr;
}

Textures::Raster Textures::scaled(const std::string& name, double low, double high, const FieldInfo& allowed,
                                  const Path& map) {
  const TextureFile* texture = file(name, map);
  if (texture == nullptr || problems_.has(map)) return nullptr;
  Raster& made = numbers_[{name, low, high}];
  if (made != nullptr) return made;
  const math::Raster& source = texture->raster;
  auto raster = std::make_shared<math::Raster>();
  raster->width = source.width;
  raster->height = source.height;
  const auto channels = static_cast<std::size_t>(source.channels);
  raster->values.resize(source.values.size() / channels);
  for (std::size_t i = 0; i < raster->values.size(); ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < channels; ++c) sum += source.values[i * channels + c];
    const double value = low + (high - low) * (sum / static_cast<double>(channels));
    if (!allowed.range.contains(value)) {
      problems_.add(Path{&map, "file"}, "expected a picture with values of " + range_text(allowed) + ", got " +
                                            value_text(value) + " in " + pixel_text(source, i));
      return nullptr;
    }
    raster->values[i] = static_cast<float>(value);
  }
  return made = std::move(raster);
}

TexturePicture Textures::numbers(const NumberMapDesc& map, const Path& path) {
  return {scaled(map.file, map.low, map.high, {.range = share_range}, path), map.repeat.u, map.repeat.v};
}

// Nanometres where 0..1 is expected, or the other way round.
void Textures::warn_of_units(const ThicknessMapDesc& map, const math::Raster& picture, const Path& path) {
  constexpr double overshoot = 1.1;       // of 0..1, as filters make it
  constexpr double thinnest_film_nm = 5;  // about the thinnest that stands, a Newton black film
  const double largest = *std::max_element(picture.values.begin(), picture.values.end());
  const Path place{&path, "file"};
  if (map.low_nm && largest > overshoot)
    problems_.add_warning(place, "the picture's values go up to " + format_number(largest, 3) +
                                     ", but between 'low_nm' and 'high_nm' they count as 0..1; a picture of nanometres "
                                     "takes neither");
  if (!map.low_nm && largest < thinnest_film_nm)
    problems_.add_warning(place, "the picture's values count as nanometres and go up to no more than " +
                                     format_number(largest, 3) + "; a picture of 0..1 needs 'low_nm' and 'high_nm'");
}

// Six square faces below each other are no picture that anyone lays over a surface.
void Textures::warn_of_layout(const math::Raster& picture, const std::string& name, const Path& path) {
  if (picture.height != film::face_count * picture.width || picture.width < 2) return;
  problems_.add_warning(Path{&path, "layout"}, "'" + printable(name) + "' has " + size_text(picture) +
                                                   ", six times as high as wide like the faces of a cube; expected "
                                                   "layout: cube for those, and a picture twice as wide as high for "
                                                   "latitude and longitude");
}

Textures::Raster Textures::frame_nm(const std::string& name, const ThicknessMapDesc& map, const Path& path) {
  const TextureFile* texture = file(name, path);
  if (texture == nullptr || problems_.has(path)) return nullptr;
  if (texture->whole_numbers && !map.low_nm) {
    problems_.add(path, "expected 'low_nm' and 'high_nm' beside a picture of whole numbers (" +
                            std::to_string(texture->bits) + " bits), which holds no nanometres");
    return nullptr;
  }
  warn_of_units(map, texture->raster, path);
  const FieldInfo allowed{.unit = "nm", .range = film::thickness_range_nm};
  return scaled(name, map.low_nm.value_or(0), map.high_nm.value_or(1), allowed, path);
}

std::variant<TexturePicture, std::shared_ptr<const film::SphereMap>> Textures::thickness_nm(const ThicknessMapDesc& map,
                                                                                            double time_s,
                                                                                            const Path& path) {
  for (const std::string_view key : {"layout", "first_frame", "last_frame", "frames_per_second"})
    if (problems_.has(Path{&path, key})) return {};
  const Frames frames = frames_at(map, time_s);
  Raster raster = frame_nm(frames.first, map, path);
  if (raster != nullptr && !frames.second.empty()) {
    const Raster second = frame_nm(frames.second, map, path);
    if (second == nullptr) return {};
    if (second->width != raster->width || second->height != raster->height) {
      problems_.add(Path{&path, "file"}, "expected frames of one size, got " + size_text(*raster) + " in '" +
                                             frames.first + "' and " + size_text(*second) + " in '" + frames.second +
                                             "'");
      return {};
    }
    raster = mixture(*raster, *second, frames.share);
  }
  if (raster == nullptr) return TexturePicture{};
  if (!same_name(map.layout, "cube")) {
    warn_of_layout(*raster, frames.first, path);
    return TexturePicture{raster, map.repeat.u, map.repeat.v};
  }
  std::shared_ptr<const film::SphereMap>& cube = cubes_[raster];
  if (cube == nullptr) {
    Result<film::SphereMap> made = film::sphere_map(*raster);
    if (made)
      cube = std::make_shared<const film::SphereMap>(*std::move(made));
    else
      problems_.add(Path{&path, "file"}, "'" + printable(frames.first) + "': " + made.errors().front().message);
  }
  return cube;
}

Textures::Raster Textures::linear_rgb(const TextureFile& texture, const Path& map) {
  const math::Raster& source = texture.raster;
  auto raster = std::make_shared<math::Raster>();
  raster->width = source.width;
  raster->height = source.height;
  raster->channels = 3;
  raster->values.resize(static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height) * 3);
  std::size_t above = 0;
  for (std::size_t i = 0; i < raster->values.size(); ++i) {
    double value = source.values[source.channels == 3 ? i : i / 3];
    if (texture.whole_numbers) value = color::decode_srgb(value);
    above += value > 1;
    raster->values[i] = static_cast<float>(std::clamp(value, 0.0, 1.0));
  }
  const Path place{&map, "file"};
  if (above > 0) problems_.add_warning(place, std::to_string(above) + " values of the picture above 1 became 1");
  return raster;
}

TexturePicture Textures::colors(const ColorMapDesc& map, const Path& path) {
  const TextureFile* texture = file(map.file, path);
  if (texture == nullptr) return {};
  Raster& raster = colors_[map.file];
  if (raster == nullptr) raster = linear_rgb(*texture, path);
  return {raster, map.repeat.u, map.repeat.v};
}

}  // namespace shabon::scene
