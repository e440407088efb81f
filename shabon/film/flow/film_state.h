// What a simulated film is at one time: all that the next step depends on besides the description.
#pragma once

#include <cstdint>
#include <optional>

#include "shabon/film/flow/flow.h"
#include "shabon/film/flow/padded.h"

namespace shabon::film {

struct FilmState {
  double time_s = 0;
  Numbers thickness;               // m
  Numbers surfactant;              // of its mean at the start
  Numbers surfactant_last;         // one step ago: the solver's guess goes on from it
  Numbers along;                   // m/s, along the edges
  Numbers push;                    // m/s^2, along the edges: by all but inertia and shear, in the last step
  double surfactant_at_start = 0;  // integral, m^2
  double drop_m3 = 0, evaporated_m3 = 0;
  std::int64_t patches = 0, spots = 0;  // random events so far
  std::optional<FilmFlow::Rupture> rupture;
  FlowReport frame;  // what is counted since begin_report()
};

}  // namespace shabon::film
