// A film or another stack as the scene file states it, in optical terms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shabon/optics/interference.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack_expression.h"
#include "shabon/scene/film_desc.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"

namespace shabon::scene {

struct FilmParts {
  optics::Medium outside;  // an outer_medium(), as is `inside`
  std::vector<optics::Layer> layers;
  std::size_t varied_layer = 0;  // index into layers
  ThicknessDesc thickness;       // of that layer
  optics::Medium inside;
};

// Nothing when the film's texts cannot be understood or say more than a film may be: coherent layers. Then `problems`
// holds why. `path` leads to the film.
std::optional<FilmParts> film_parts(const MediumFilmDesc& film, const Path& path,
                                    const optics::MediumResolver& resolver, Problems& problems);
std::optional<FilmParts> film_parts(const StackFilmDesc& film, const Path& path, const optics::MediumResolver& resolver,
                                    Problems& problems);

// The stack written at `place`, or nothing and why.
std::optional<optics::Stack> stack_at(const Path& place, const std::string& text,
                                      const optics::MediumResolver& resolver, Problems& problems);

// What is clear, Medium::is_clear(), fills a scene as if it absorbed nothing, however far the light goes.
optics::Medium outer_medium(const optics::Medium& medium);

// Whether all layers are coherent and no thicker than films are.
bool check_coherent(const std::vector<optics::Layer>& layers, const Path& place, Problems& problems);

// Whether `vary` names one of the layers. `path` leads to it.
bool check_varied(const VariedLayerDesc& vary, std::size_t layer_count, const Path& path, Problems& problems);

// The media on both sides must be the same and lossless: light crosses straight only then. `place` leads to the stack.
void check_outer_media(const optics::Medium& outside, const optics::Medium& inside, const Path& place,
                       Problems& problems);

// The models other than airy know one layer.
void check_model(const FilmParts& parts, optics::Interference model, const Path& path, Problems& problems);

}  // namespace shabon::scene
