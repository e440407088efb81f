// n and k of media over wavelength, as `shabon media NAME...` prints and draws them.
#pragma once

#include <string>
#include <vector>

#include "shabon/io/svg.h"
#include "shabon/optics/medium.h"

namespace shabon::app {

struct MediaTable {
  std::vector<optics::Medium> media;
  std::vector<double> wavelengths_nm;
};

std::string media_table_text(const MediaTable& table);
// Of one medium: an n-k file that can be read again. Of several: two columns a medium, with its name.
std::string media_table_csv(const MediaTable& table);
std::string media_table_json(const MediaTable& table);

// n above, k below where a medium absorbs; dashed where the source says nothing.
io::Chart media_chart(const MediaTable& table);

}  // namespace shabon::app
