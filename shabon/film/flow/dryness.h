// When a simulated film has lost so much liquid that hardly any light comes back from it.
#pragma once

#include <optional>
#include <string>

#include "shabon/film/flow/flow.h"

namespace shabon::film {

// A film that is thinner than common black film on the mean, the usual BlackFilmDesc, shows next to nothing.
inline constexpr double common_black_film_nm = BlackFilmDesc{}.thickness_nm;

// Why a run to `until_s` ends with a dry film, and what to change; nothing where it does not, or where that cannot be
// known before (regeneration takes liquid, too; rupture may come first).
std::optional<std::string> why_dry_before(const FlowDesc& desc, double until_s);

// Why the film is dry now: its mean is below that of common black film, or half of it is as thin as any film gets. A
// film that collapses to black film is dry when its mean is within a tenth of that. Nothing for a broken film.
std::optional<std::string> why_dry(const FilmFlow& flow);

}  // namespace shabon::film
