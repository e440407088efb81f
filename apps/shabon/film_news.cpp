#include "film_news.h"

#include <fmt/format.h>

namespace shabon::app {

std::string rupture_text(const film::FilmFlow::Rupture& rupture) {
  const math::Vec3d& at = rupture.from_centre;
  return fmt::format(
      "the film broke at {:.3f} s, where it was thinner than {:.1f} nm, in the direction {:.3f} {:.3f} {:.3f}",
      rupture.time_s, rupture.threshold_nm, at.x, at.y, at.z);
}

}  // namespace shabon::app
