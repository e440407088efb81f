// The media of a scene: the one that fills all space, and those within solids.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shabon/optics/medium.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"

namespace shabon::scene {

class SceneMedia {
 public:
  explicit SceneMedia(Problems& problems) : problems_(problems) {}

  // On both sides of a film or pane, an outer_medium(): it fills the scene, and those of others must be equal. `place`
  // leads to the stack.
  void fills_space(const optics::Medium& medium, const Path& place);

  // In front of a solid's or liquid's surface, and behind one that lets light in. `place` leads to the stack.
  void in_front(const optics::Medium& medium, const Path& place);
  void behind(const optics::Medium& medium);

  // Once for each medium that is used outside the range of its source.
  void warn_outside_range(const optics::Medium& medium, const Path& place);

  // The medium that fills the scene: that of films and panes; without them the first one in front of a surface that is
  // behind no other, or air. Warns of media in front of surfaces that nothing holds.
  optics::Medium settle();

 private:
  // Different media: any number of constants, mostly few others.
  struct Media {
    std::set<std::pair<double, double>> constants;  // n and k
    std::vector<optics::Medium> others;
    bool contains(const optics::Medium& medium) const;
  };
  struct Front {
    optics::Medium medium;
    KeptPath place;
  };

  static bool add_to(Media& media, const optics::Medium& medium);

  Problems& problems_;
  std::optional<optics::Medium> space_;
  Media front_, behind_;
  std::string settled_by_;
  std::vector<Front> fronts_;
  std::set<std::string> warned_;
};

}  // namespace shabon::scene
