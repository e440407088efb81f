// Air that drags the film along. THE list of what moves it: each a plain struct with about() and fields(); flow_air.h
// computes their fields of velocity. An empty list is air at rest.
#pragma once

#include <tuple>
#include <variant>

#include "shabon/base/field.h"
#include "shabon/math/vec.h"

namespace shabon::film {

inline constexpr Range air_speed_range_m_s{.low = 0, .high = 20};
inline constexpr Range air_angle_range_deg{.low = 1, .high = 180};
inline constexpr Range air_time_range_s{.low = 0, .high = 1e6};

// When it blows: from start_s for duration_s, rising and falling smoothly within ramp_s at either end.
struct AirEnvelope {
  double start_s = 0;
  double duration_s = 1e6;
  double ramp_s = 0.2;
};

constexpr auto fields(Of<AirEnvelope>) {
  return std::tuple{
      Field{"start_s", &AirEnvelope::start_s, {.unit = "s", .range = air_time_range_s, .doc = "when it begins"}},
      Field{
          "duration_s", &AirEnvelope::duration_s, {.unit = "s", .range = air_time_range_s, .doc = "how long it blows"}},
      Field{"ramp_s",
            &AirEnvelope::ramp_s,
            {.unit = "s", .range = air_time_range_s, .doc = "time in which it rises at first and falls at last"}}};
}

// The share 0..1 at a time.
double share_at(const AirEnvelope& envelope, double time_s);

inline constexpr FieldInfo air_envelope_info{.doc = "when it blows"};

// The air around the bubble turns as a whole.
struct AirRotation {
  math::Vec3d axis{0, 1, 0};
  double speed_m_s = 0.2;  // at the equator of the axis
  AirEnvelope envelope = {};
};

constexpr About about(Of<AirRotation>) { return {.name = "rotation", .doc = "Air that turns about an axis."}; }

constexpr auto fields(Of<AirRotation>) {
  return std::tuple{
      Field{"axis", &AirRotation::axis, {.doc = "axis, of any length; counterclockwise seen from its tip"}},
      Field{"speed_m_s",
            &AirRotation::speed_m_s,
            {.unit = "m/s", .range = air_speed_range_m_s, .doc = "speed at the equator of the axis"}},
      Field{"envelope", &AirRotation::envelope, air_envelope_info}};
}

// A stream of air over one side of the bubble.
struct AirJet {
  math::Vec3d place{0, 0, 1};
  math::Vec3d direction{1, 0, 0};
  double speed_m_s = 0.5;
  double half_width_deg = 35;
  AirEnvelope envelope = {};
};

constexpr About about(Of<AirJet>) { return {.name = "jet", .doc = "A stream of air over one side."}; }

constexpr auto fields(Of<AirJet>) {
  return std::tuple{
      Field{"place", &AirJet::place, {.doc = "where it is strongest: a direction from the centre, of any length"}},
      Field{"direction",
            &AirJet::direction,
            {.doc = "where it blows to, of any length: along the film, what blows at it moves nothing"}},
      Field{"speed_m_s",
            &AirJet::speed_m_s,
            {.unit = "m/s", .range = air_speed_range_m_s, .doc = "speed where it is strongest"}},
      Field{"half_width_deg",
            &AirJet::half_width_deg,
            {.unit = "degrees", .range = air_angle_range_deg, .doc = "angle at which it has fallen to 1/e"}},
      Field{"envelope", &AirJet::envelope, air_envelope_info}};
}

// Puffs at seeded places and times, each a short jet along the surface.
struct AirGusts {
  double rate_per_s = 1;
  double speed_m_s = 1;
  double half_width_deg = 30;
  double length_s = 0.5;
  AirEnvelope envelope = {};
};

constexpr About about(Of<AirGusts>) { return {.name = "gusts", .doc = "Puffs of air at random places and times."}; }

constexpr auto fields(Of<AirGusts>) {
  return std::tuple{
      Field{"rate_per_s",
            &AirGusts::rate_per_s,
            {.unit = "1/s", .range = {.low = 0, .high = 20}, .doc = "puffs a second"}},
      Field{"speed_m_s",
            &AirGusts::speed_m_s,
            {.unit = "m/s", .range = air_speed_range_m_s, .doc = "speed of the strongest; the weakest has half of it"}},
      Field{"half_width_deg",
            &AirGusts::half_width_deg,
            {.unit = "degrees", .range = air_angle_range_deg, .doc = "angle at which a puff has fallen to 1/e"}},
      Field{"length_s",
            &AirGusts::length_s,
            {.unit = "s", .range = {.low = 0.01, .high = 10}, .doc = "how long each lasts"}},
      Field{"envelope", &AirGusts::envelope, air_envelope_info}};
}

// Swirls without sources: the curl of band-limited noise, changing with time.
struct AirSwirls {
  double speed_m_s = 0.3;
  double scale_m = 0.02;
  double change_s = 4;
  AirEnvelope envelope = {};
};

constexpr About about(Of<AirSwirls>) { return {.name = "swirls", .doc = "Random eddies of air (curl noise)."}; }

constexpr auto fields(Of<AirSwirls>) {
  return std::tuple{
      Field{"speed_m_s",
            &AirSwirls::speed_m_s,
            {.unit = "m/s", .range = air_speed_range_m_s, .doc = "root mean square of the speed"}},
      Field{"scale_m",
            &AirSwirls::scale_m,
            {.unit = "m", .range = {.low = 1e-3, .high = 1}, .doc = "size of the eddies: half a wavelength"}},
      Field{"change_s",
            &AirSwirls::change_s,
            {.unit = "s", .range = {.low = 0.01, .high = 1e6}, .doc = "time after which the pattern comes back"}},
      Field{"envelope", &AirSwirls::envelope, air_envelope_info}};
}

using AirMotion = std::variant<AirRotation, AirJet, AirGusts, AirSwirls>;

}  // namespace shabon::film
