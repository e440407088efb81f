// How thick a film is at one moment, ready to be asked at many places: a thickness model with all prepared that does
// not depend on the place, or a map; perhaps with a hole.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include "shabon/film/holed_film.h"
#include "shabon/film/latitude_map.h"
#include "shabon/film/sphere_map.h"
#include "shabon/film/thickness.h"

namespace shabon::film {

namespace detail {

// A model is evaluated as it stands, unless it says otherwise: by prepared(model, seconds), which returns another
// struct with a thickness_nm() of its own.
template <class Model>
auto ready(const Model& model, [[maybe_unused]] double seconds) {
  if constexpr (requires { prepared(model, seconds); })
    return prepared(model, seconds);
  else
    return model;
}

// The variant with T too, if it does not hold one.
template <class Variant, class... T>
struct With {
  using type = Variant;
};
template <class... Held, class T, class... More>
struct With<std::variant<Held...>, T, More...>
    : With<std::conditional_t<(std::is_same_v<Held, T> || ...), std::variant<Held...>, std::variant<Held..., T>>,
           More...> {};

template <class Models, class... Maps>
struct ReadyOf;
template <class First, class... Models, class... Maps>
struct ReadyOf<std::variant<First, Models...>, Maps...>
    : With<std::variant<First>, decltype(ready(std::declval<const Models&>(), 0.0))..., Maps...> {};

}  // namespace detail

using ThicknessField = detail::ReadyOf<ThicknessModel, std::shared_ptr<const SphereMap>, LatitudeMap, HoledFilm>::type;

struct HeldField {
  ThicknessField field;
};

// Of a map that its owner replaces from one picture to the next.
template <class Number>
Number thickness_nm(const std::shared_ptr<const SphereMap>& map, const math::Vec3<Number>& from_centre) {
  return thickness_nm(*map, from_centre);
}

template <class Number>
Number thickness_nm(const NoiseField& film, const math::Vec3<Number>& from_centre);
template <class Number>
Number thickness_nm(const HoledFilm& holed, const math::Vec3<Number>& from_centre);

// Thickness in nm in the unit direction `from_centre` of a sphere; Number is double or a packet of it. Other shapes
// give a place within their box, in units of half its height.
template <class Number>
Number thickness_nm(const ThicknessField& field, const math::Vec3<Number>& from_centre) {
  return std::visit([&](const auto& chosen) { return thickness_nm(chosen, from_centre); }, field);
}

// No less than none, no more than a film may have.
template <class Number>
Number thickness_nm(const NoiseField& film, const math::Vec3<Number>& from_centre) {
  using std::max, std::min;
  const Number share = Number(1.0) + Number(film.amplitude) * noise_at(*film.waves, from_centre);
  const Number nm = thickness_nm(film.base->field, from_centre) * share;
  return min(max(nm, Number(thickness_range_nm.low)), Number(thickness_range_nm.high));
}

template <class Number>
Number thickness_nm(const HoledFilm& holed, const math::Vec3<Number>& from_centre) {
  return detail::outside_hole(holed, from_centre, thickness_nm(holed.film->field, from_centre));
}

// Its mean over all directions, to about a thousandth.
double mean_thickness_nm(const ThicknessField& field);

// The model as it is `seconds` after the moment its parameters speak of; models that do not age are the same ever
// after.
ThicknessField at_time(const ThicknessModel& model, double seconds);

}  // namespace shabon::film
