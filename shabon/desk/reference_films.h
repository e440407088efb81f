// What the tables of one film share. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "shabon/desk/reference_tables.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

// The stack of the film's expression.
optics::Stack reference_stack(const ReferenceFilm& film);

// "air | SiO2 d | Si", with d for the swept layer.
std::string reference_formula(const ReferenceFilm& film);

// 0, step, ... last, nm.
std::vector<double> reference_thicknesses_nm(const ReferenceFilm& film);

// 360, 370, ... 830 nm.
std::vector<double> reference_wavelengths_nm();

// The media of all films that are not constant, each once.
std::vector<optics::Medium> reference_media();

// One line of a head for each different medium of the film: its name, source and what was done beyond its range.
std::string media_lines(const std::vector<optics::Medium>& media);
std::vector<optics::Medium> media_of(const optics::Stack& stack);

}  // namespace shabon::desk
