// What somebody else's program does: the colour of a soap film, a small picture of a bubble, then the version of the
// library they came from.
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <vector>

#include "shabon/api/version.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/media.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/render/render.h"
#include "shabon/scene/built_in.h"
#include "shabon/scene/compile.h"

// The built-in bubble, 16 by 12 pixels: light arrives at every one.
bool renders() {
  const std::vector<std::string> small{"image.width=16", "image.height=12", "render.samples=1"};
  const auto scene = shabon::scene::load_scene(shabon::scene::built_in_scene(), "built-in", small, {}, nullptr);
  if (!scene) return false;
  shabon::render::Sensor sensor(scene->width, scene->height);
  const auto report = shabon::render::render(*scene, {}, sensor);
  if (!report || report->samples_done != 1) return false;
  for (int y = 0; y < scene->height; ++y)
    for (int x = 0; x < scene->width; ++x)
      if (!(sensor.mean(x, y).y > 0)) return false;
  return true;
}

int main() {
  const auto water = shabon::optics::find_medium("Water");
  const auto* daylight = shabon::color::find_illuminant("D65");
  if (!water || daylight == nullptr) return 1;

  shabon::color::Spectrum reflectance{};
  for (int i = 0; i < shabon::color::spectrum_size; ++i) {
    const double wavelength_nm = shabon::color::first_nm + i;
    const shabon::optics::Powers powers = shabon::optics::airy(
        1, water->index(wavelength_nm), 1, 300, shabon::optics::incidence_from(shabon::Degrees(45)), wavelength_nm);
    if (std::abs(powers.R_s + powers.T_s - 1) > 1e-12) return 2;
    reflectance[static_cast<std::size_t>(i)] = (powers.R_s + powers.R_p) / 2;
  }
  const shabon::color::Xyz colour = shabon::color::reflectance_to_xyz(reflectance, *daylight);
  if (!(colour.y > 0.001 && colour.y < 0.2)) return 3;
  const std::string hex = shabon::color::to_hex(shabon::color::encode_srgb(shabon::color::xyz_to_linear_srgb(colour)));
  if (!renders()) return 4;
  std::printf("shabon %s: %s\n", std::string(shabon::version()).c_str(), hex.c_str());
  return 0;
}
