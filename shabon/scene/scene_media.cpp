#include "shabon/scene/scene_media.h"

#include <algorithm>
#include <complex>

#include "shabon/color/spectrum.h"
#include "shabon/scene/film_parts.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

std::pair<double, double> constant_of(const optics::Medium& medium) {
  const std::complex<double> index = medium.index(color::first_nm);
  return {index.real(), index.imag()};
}

}  // namespace

bool SceneMedia::Media::contains(const optics::Medium& medium) const {
  if (medium.is_constant()) return constants.contains(constant_of(medium));
  return std::find(others.begin(), others.end(), medium) != others.end();
}

bool SceneMedia::add_to(Media& media, const optics::Medium& medium) {
  if (media.contains(medium)) return false;
  if (medium.is_constant())
    media.constants.insert(constant_of(medium));
  else
    media.others.push_back(medium);
  return true;
}

void SceneMedia::fills_space(const optics::Medium& medium, const Path& place) {
  if (!space_) {
    space_ = medium;
    settled_by_ = place.parent->text();
  } else if (!(*space_ == medium) && !problems_.has(place)) {
    problems_.add(place, "expected the outer medium '" + space_->name() + "' of " + settled_by_ + ", got '" +
                             medium.name() + "'; all films and panes of a scene stand in one medium");
  }
}

void SceneMedia::in_front(const optics::Medium& medium, const Path& place) {
  const optics::Medium outer = outer_medium(medium);
  if (add_to(front_, outer)) fronts_.push_back({outer, KeptPath(place)});
}

void SceneMedia::behind(const optics::Medium& medium) { add_to(behind_, outer_medium(medium)); }

void SceneMedia::warn_outside_range(const optics::Medium& medium, const Path& place) {
  const std::string note = medium.outside_range_note(optics::WavelengthRange{color::first_nm, color::last_nm});
  if (!note.empty() && warned_.insert(medium.name()).second) problems_.add_warning(place, note);
}

optics::Medium SceneMedia::settle() {
  const auto outermost =
      std::find_if(fronts_.begin(), fronts_.end(), [&](const Front& front) { return !behind_.contains(front.medium); });
  optics::Medium medium;  // air
  if (space_)
    medium = *space_;
  else if (outermost != fronts_.end())
    medium = outermost->medium;
  std::size_t warnings = 0;
  for (const Front& front : fronts_) {
    const Path& place = front.place.path();
    if (front.medium == medium) {
      if (!medium.is_lossless() && !problems_.has(place))
        problems_.add(place, "expected a medium without absorption (k of at most " +
                                 value_text(optics::most_k_of_clear) + ") in front of the surface, got '" +
                                 medium.name() + "', which nothing holds; light comes through it from any distance");
      continue;
    }
    if (behind_.contains(front.medium) || problems_.has(place) || ++warnings > Problems::most_shown) continue;
    problems_.add_warning(place, "the surface begins in '" + front.medium.name() +
                                     "', which no other object holds; the medium of the scene is '" + medium.name() +
                                     "'");
  }
  return medium;
}

}  // namespace shabon::scene
