// What adds to the film's liquid, moves or removes it besides the flow. Each is a plain struct with fields(); absent is
// without it. The liquid that leaves goes to a ledger.
#pragma once

#include <tuple>

#include "shabon/base/field.h"

namespace shabon::film {

struct EvaporationDesc {
  double rate_nm_s = 40;
  double top_excess = 0;
};

constexpr auto fields(Of<EvaporationDesc>) {
  return std::tuple{Field{"rate_nm_s",
                          &EvaporationDesc::rate_nm_s,
                          {.unit = "nm/s",
                           .range = {.low = 0, .high = 200},
                           .doc = "thickness lost on both sides together, down to 4 nm or to black film"}},
                    Field{"top_excess",
                          &EvaporationDesc::top_excess,
                          {.range = {.low = -1, .high = 1},
                           .doc = "share by which it is faster at the top and slower at the bottom"}}};
}

// Thick film is sucked into the drop at the bottom and comes back thinner.
struct RegenerationDesc {
  double ratio = 0.85;
  double patch_radius_m = 2.5e-3;
  double rate_per_s = 40;
  double from_deg = 20;
  double to_deg = 35;
};

constexpr auto fields(Of<RegenerationDesc>) {
  return std::tuple{
      Field{"ratio",
            &RegenerationDesc::ratio,
            {.range = {.low = 0.5, .high = 1}, .doc = "thickness of a new patch over that of the film before"}},
      Field{"patch_radius_m",
            &RegenerationDesc::patch_radius_m,
            {.unit = "m", .range = {.low = 2e-4, .high = 0.02}, .doc = "where a patch has fallen to 1/e"}},
      Field{"rate_per_s",
            &RegenerationDesc::rate_per_s,
            {.unit = "1/s", .range = {.low = 0, .high = 2000}, .doc = "patches a second, at random places"}},
      Field{"from_deg",
            &RegenerationDesc::from_deg,
            {.unit = "degrees", .range = {.low = 0, .high = 180}, .doc = "nearest to the lowest point"}},
      Field{"to_deg",
            &RegenerationDesc::to_deg,
            {.unit = "degrees", .range = {.low = 0, .high = 180}, .doc = "farthest from the lowest point"}}};
}

// Below a thickness the film collapses at seeded spots to its black thickness; the liquid goes into the film around.
struct BlackFilmDesc {
  double thickness_nm = 30;
  double nucleation_nm = 60;
  double spots_per_s = 20;
  double front_m_s = 0.01;
};

constexpr auto fields(Of<BlackFilmDesc>) {
  return std::tuple{
      Field{"thickness_nm",
            &BlackFilmDesc::thickness_nm,
            {.unit = "nm", .range = {.low = 4, .high = 50}, .doc = "of black film: 5 (Newton) or 10 to 30 (common)"}},
      Field{"nucleation_nm",
            &BlackFilmDesc::nucleation_nm,
            {.unit = "nm", .range = {.low = 5, .high = 200}, .doc = "below this spots can form and grow"}},
      Field{"spots_per_s",
            &BlackFilmDesc::spots_per_s,
            {.unit = "1/s",
             .range = {.low = 0, .high = 1000},
             .doc = "chances a second and square centimetre of thin film"}},
      Field{"front_m_s",
            &BlackFilmDesc::front_m_s,
            {.unit = "m/s", .range = {.low = 0, .high = 1}, .doc = "speed at which a spot grows"}}};
}

// The film breaks where it is thinner than a seeded thickness between the two.
struct RuptureDesc {
  double from_nm = 10;
  double to_nm = 100;
};

constexpr auto fields(Of<RuptureDesc>) {
  constexpr Range range{.low = 0, .high = 1000};
  return std::tuple{Field{"from_nm", &RuptureDesc::from_nm, {.unit = "nm", .range = range, .doc = "least threshold"}},
                    Field{"to_nm", &RuptureDesc::to_nm, {.unit = "nm", .range = range, .doc = "largest threshold"}}};
}

}  // namespace shabon::film
