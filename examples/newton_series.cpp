// Newton's series: the colours of an oxide that grows on titanium, from 0 to 200 nm. A sweep shares everything that
// does not depend on the thickness, so that a series of thousands takes milliseconds.
#include <cstdio>

#include "shabon/api/shabon.h"

using namespace shabon;

int main() {
  const auto titanium = optics::parse_stack("air | TiO2 0nm | Ti");
  if (!titanium) return std::fputs(to_text(titanium.errors()).c_str(), stderr), 3;

  desk::Sweep series;
  series.stack = *titanium;
  series.layer = 0;
  for (int thickness_nm = 0; thickness_nm <= 200; thickness_nm += 20) series.thicknesses_nm.push_back(thickness_nm);

  const color::Illuminant& lamp = *color::find_illuminant("D65");
  const auto colours = desk::swept_colors(series, lamp);
  if (!colours) return std::fputs(to_text(colours.errors()).c_str(), stderr), 3;
  for (std::size_t i = 0; i < colours->size(); ++i) {
    const desk::Color colour = desk::color_of((*colours)[i], color::white_point(lamp));
    std::printf("%3g nm  %s  L* %.2f a* %.2f b* %.2f\n", series.thicknesses_nm[i],
                color::to_hex(colour.srgb_mapped).c_str(), colour.lab.L, colour.lab.a, colour.lab.b);
  }
}
