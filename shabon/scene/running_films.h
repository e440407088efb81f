// The simulated films of a scene, as they run from one picture to the next.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shabon/base/progress.h"
#include "shabon/base/result.h"
#include "shabon/film/flow/bake.h"
#include "shabon/film/flow/flow.h"
#include "shabon/scene/scene.h"

namespace shabon::scene {

class RunningFilms {
 public:
  // All simulated films of the scene, at their time 0. Errors as FilmFlow::start().
  static Result<RunningFilms> start(const Scene& scene);

  // Runs every film on to that time; earlier times change nothing. What a film is then does not depend on the times
  // asked for before. `progress` is told the share of that time that is done. Errors as FilmFlow::advance_to().
  Status advance_to(double time_s, const StopFlag* stop = nullptr, const ProgressReport& progress = {});

  // Puts the thickness of this moment into the scene, which is the one of start() or one compiled from it for another
  // time; a film that broke has the hole of the scene's time. Once for a scene.
  void show_in(Scene& scene) const;

  // The film that broke first, if one did.
  std::optional<film::FilmFlow::Rupture> rupture() const;

  // Warnings: films that will be dry by then, and films that became dry since the last call (film/flow/dryness.h). Of
  // each film one of the two, once.
  Diagnostics forecast(double until_s);
  Diagnostics news();

 private:
  struct Running {
    film::FilmFlow flow;
    film::FlowBake bake;
    int map_size;
    std::vector<std::byte> pause = {};  // where to go on from, after a look at a moment between two pauses
    bool told_dry = false;
  };
  static Status return_to_pause(Running& running);
  void tell_dry(std::size_t film, const std::optional<std::string>& why, Diagnostics& told);
  std::vector<Running> films_;  // in the order of the scene's simulated films
  Diagnostics news_;
};

// Runs every simulated film of the scene to the scene's time and shows it there. Errors as above.
Status run_films(Scene& scene, const StopFlag* stop = nullptr, const ProgressReport& progress = {});

}  // namespace shabon::scene
