#include "shabon/scene/compile_environment.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/units.h"
#include "shabon/scene/schema_fields.h"

namespace shabon::scene {

namespace {

constexpr double turn_deg = 360;

double radians(double degrees) { return Radians(Degrees(degrees)).value; }

math::Vec3d unit(const math::Vec3d& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return length > 0 ? v * (1 / length) : math::Vec3d{0, 1, 0};
}

// Texels with the first column repeated after the last; nothing when the picture is not what it says.
std::shared_ptr<const EnvironmentPicture> texels_of(const io::RgbImage& image) {
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgb.size() != 3 * width * height) return nullptr;
  if (!std::all_of(image.rgb.begin(), image.rgb.end(), [](float v) { return std::isfinite(v) && v >= 0; }))
    return nullptr;
  auto picture = std::make_shared<EnvironmentPicture>();
  picture->width = image.width;
  picture->height = image.height;
  picture->texels.resize((width + 1) * height * 4);
  float* texel = picture->texels.data();
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column <= width; ++column, texel += 4)
      std::copy_n(image.rgb.data() + 3 * (row * width + column % width), 3, texel);
  return picture;
}

class EnvironmentCompiler {
 public:
  EnvironmentCompiler(const Path& path, const Resources& resources, LampChannels& lamps, Problems& problems)
      : path_(path), resources_(resources), problems_(problems), lamps_(lamps) {}

  BaseLight base(const ConstantEnvironmentDesc& light) {
    ConstantLight result;
    result.channel = lamps_.of(light.illuminant, below(light));
    result.scale = light.scale;
    return result;
  }

  BaseLight base(const GradientEnvironmentDesc& light) {
    GradientLight result;
    const Path gradient = below(light);
    result.up_channel = lamps_.of(light.up.illuminant, Path{&gradient, "up"});
    result.down_channel = lamps_.of(light.down.illuminant, Path{&gradient, "down"});
    result.up_scale = light.up.scale;
    result.down_scale = light.down.scale;
    return result;
  }

  BaseLight base(const ImageEnvironmentDesc& light) {
    ImageLight result;
    result.picture = picture(light.file);
    result.first_channel = lamps_.of_picture();
    result.rotation_turns = light.rotation_deg / turn_deg;
    result.scale = light.scale;
    return result;
  }

  BaseLight base(const SkyEnvironmentDesc& light) {
    const bool wrong = problems_.has(below(light));
    const SkyConditions conditions{
        light.sun_elevation_deg, light.sun_azimuth_deg, light.turbidity, light.scale, light.sun, light.ground_albedo};
    SkyAndSun made = sky_and_sun(wrong ? SkyConditions{} : conditions, static_cast<int>(lamps_.spectra.size()));
    lamps_.spectra.insert(lamps_.spectra.end(), made.channels.begin(), made.channels.end());
    sun_ = made.sun;
    return made.sky;
  }

  // What the base brings along.
  const std::optional<RoundSoftbox>& sun() const { return sun_; }

  Softbox softbox(const SoftboxDesc& light, const Path& place) {
    const math::Vec3d direction = unit(light.direction);
    const int lamp = lamps_.of(light.illuminant, place);
    if (const auto* round = std::get_if<RoundShapeDesc>(&light.shape))
      return round_softbox(direction, radians(round->half_angle_deg), lamp, light.scale);
    const auto& window = std::get<WindowShapeDesc>(light.shape);
    return window_softbox(direction, radians(window.width_deg), radians(window.height_deg), radians(window.roll_deg),
                          lamp, light.scale);
  }

 private:
  template <class Light>
  Path below(const Light&) const {
    return Path{&path_, about(Of<Light>{}).name};
  }

  std::shared_ptr<const EnvironmentPicture> picture(const std::string& file) {
    const Path image{&path_, about(Of<ImageEnvironmentDesc>{}).name};
    const Path place{&image, "file"};
    if (problems_.has(place)) return nullptr;
    const Result<io::RgbImage> loaded = resources_.picture(file);
    if (!loaded) {
      for (const Diagnostic& error : loaded.errors()) problems_.add_from_file(place, error);
      return nullptr;
    }
    auto picture = texels_of(*loaded);
    if (picture == nullptr) problems_.add(place, "expected a picture of finite values >= 0, got one that is not");
    if (loaded->negatives > 0)
      problems_.add_warning(place, std::to_string(loaded->negatives) + " negative values of the picture became 0");
    return picture;
  }

  const Path& path_;
  const Resources& resources_;
  Problems& problems_;
  LampChannels& lamps_;
  std::optional<RoundSoftbox> sun_;
};

}  // namespace

Environment compile_environment(const EnvironmentDesc& description, const Path& path, const Resources& resources,
                                LampChannels& lamps, Problems& problems) {
  EnvironmentCompiler compiler(path, resources, lamps, problems);
  Environment environment;
  environment.base = std::visit([&](const auto& light) { return compiler.base(light); }, description.base);
  const Path softboxes{&path, "softboxes"};
  for (const SoftboxDesc& softbox : description.softboxes) {
    const Path place{&softboxes, {}, static_cast<int>(environment.softboxes.size())};
    environment.softboxes.push_back(compiler.softbox(softbox, place));
  }
  if (compiler.sun()) environment.softboxes.push_back(*compiler.sun());
  return environment;
}

}  // namespace shabon::scene
