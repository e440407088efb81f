// What simulate, animate and render tell alike of simulated films.
#pragma once

#include <string>

#include "shabon/film/flow/flow.h"

namespace shabon::app {

// "the film broke at 1.234 s, where it was thinner than ..."
std::string rupture_text(const film::FilmFlow::Rupture& rupture);

}  // namespace shabon::app
