// What somebody else's program does: the colour of a soap film, then the version of the library it came from.
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>

#include "shabon/api/version.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/media.h"
#include "shabon/optics/reference/airy.h"

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
  std::printf("shabon %s: %s\n", std::string(shabon::version()).c_str(), hex.c_str());
  return 0;
}
