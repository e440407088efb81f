// A film as the scene file states it, in optical terms.
#pragma once

#include <optional>

#include "shabon/film/thickness.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack_expression.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/scene.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

struct FilmParts {
  optics::Medium outside;  // without absorption where it is clear, Medium::is_clear(); likewise inside
  Film film;
  optics::Medium inside;
};

// Nothing when the film's texts cannot be understood or say more than the renderer supports: coherent layers. Then
// `problems` holds why. `path` leads to the film.
std::optional<FilmParts> film_parts(const MediumFilmDesc& film, const Path& path,
                                    const optics::MediumResolver& resolver, Problems& problems);
std::optional<FilmParts> film_parts(const StackFilmDesc& film, const Path& path, const optics::MediumResolver& resolver,
                                    Problems& problems);

// The media outside and inside must be the same and lossless: light crosses a film straight only then.
void check_outer_media(const FilmParts& parts, const Path& path, Problems& problems);

// The models other than airy know one layer.
void check_model(const FilmParts& parts, optics::Interference model, const Path& path, Problems& problems);

}  // namespace shabon::scene
