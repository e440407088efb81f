// The colour of a soap film, 300 nm thick, seen at 45 degrees under daylight.
#include <cstdio>

#include "shabon/api/shabon.h"

using namespace shabon;

int main() {
  const auto film = optics::parse_stack("air | water 300nm | air");
  if (!film) return std::fputs(to_text(film.errors()).c_str(), stderr), 3;

  const color::Spectrum reflected =
      desk::unpolarised(*film, optics::Interference::airy, optics::incidence_from(45_deg), desk::Side::reflected);
  const desk::Color colour = desk::color_of(reflected, *color::find_illuminant("D65"));
  std::printf("XYZ %.6f %.6f %.6f, sRGB %s\n", colour.xyz.x, colour.xyz.y, colour.xyz.z,
              color::to_hex(colour.srgb_mapped).c_str());
}
