// The words of the reference tables: heads, index and README. Inside the room only.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "shabon/desk/reference_tables.h"

namespace shabon::desk {

// Lines that begin with '#', then the names of the columns.
std::string spectra_head(const ReferenceFilm& film, std::string_view program_version);
std::string colors_head(const ReferenceFilm& film, std::string_view program_version);

// Without the names of the columns.
std::string media_head(std::string_view program_version);
std::string light_head(std::string_view program_version);

// Of the tables before them in the list.
std::string index_text(std::span<const ReferenceFile> files, std::string_view program_version);
std::string readme_text(std::span<const ReferenceFile> files, std::string_view program_version);

}  // namespace shabon::desk
