// What a bubble's shape does at the scene's time: it trembles and bursts.
#pragma once

#include <optional>

#include "shabon/film/popping.h"
#include "shabon/scene/bubble_desc.h"
#include "shabon/scene/scene.h"

namespace shabon::scene {

// The bubble in nature at a time; nothing, and a problem, where its mean thickness is not known. `path` leads to the
// bubble.
std::optional<film::BubbleBody> body_of(const BubbleDesc& bubble, const Film& film, double metres_per_unit,
                                        double time_s, const Path& path, Problems& problems);

// The shape at a time, for a radius of 1, (90).
geometry::LobedSphere trembling(const std::vector<film::ShapeMode>& modes, const film::BubbleBody& body, double time_s);

// Whether the amplitudes are those of a bubble that only trembles. `path` leads to the bubble.
bool check_modes(const std::vector<film::ShapeMode>& modes, const film::BubbleBody& body, const Path& path,
                 Problems& problems);

// Opens the hole in the film: all of it within is gone, and is in the rim.
void open_hole(Film& film, const film::Hole& hole, const film::BubbleBody& body, const math::Vec3d& from_centre);

// Gives the open films of round bubbles their rims, as rings of the films' liquid: once.
void add_rims(Scene& scene);

// How a simulated film bursts, if it does. The body is that of body_of().
std::optional<Bursting> bursting_of(const BubbleDesc& bubble, const Film& film, film::BubbleBody body);

// Films of several layers cannot burst.
bool check_popping(const Film& film, const Path& path, Problems& problems);

}  // namespace shabon::scene
