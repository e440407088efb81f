// What a simulated film tells about itself, one row a frame.
#pragma once

#include <tuple>

#include "shabon/base/field.h"

namespace shabon::film {

// Volumes of the whole bubble: film + drop + evaporated is constant.
struct FlowReport {
  double time_s = 0;
  double film_m3 = 0;
  double drop_m3 = 0;
  double evaporated_m3 = 0;
  double surfactant = 0;  // relative to the start
  double thinnest_nm = 0, mean_nm = 0, thickest_nm = 0;
  double black_share = 0;  // of the area
  double fastest_m_s = 0;
  double courant = 0;  // largest
  double shortest_step_s = 0, longest_step_s = 0;
  int steps = 0;
  int iterations = 0;  // of the Marangoni solver, all steps together
  int repeated = 0;    // steps that were taken back and made shorter
};

// In the order of a table's columns.
constexpr auto fields(Of<FlowReport>) {
  return std::tuple{
      Field{"time_s", &FlowReport::time_s, {.unit = "s", .doc = "time since the start"}},
      Field{"film_m3", &FlowReport::film_m3, {.unit = "m^3", .doc = "liquid in the film"}},
      Field{"drop_m3", &FlowReport::drop_m3, {.unit = "m^3", .doc = "liquid that went to the drop at the bottom"}},
      Field{"evaporated_m3", &FlowReport::evaporated_m3, {.unit = "m^3", .doc = "liquid that evaporated"}},
      Field{"surfactant", &FlowReport::surfactant, {.doc = "surfactant, relative to the start"}},
      Field{"thinnest_nm", &FlowReport::thinnest_nm, {.unit = "nm", .doc = "least thickness"}},
      Field{"mean_nm", &FlowReport::mean_nm, {.unit = "nm", .doc = "mean thickness over the area"}},
      Field{"thickest_nm", &FlowReport::thickest_nm, {.unit = "nm", .doc = "largest thickness"}},
      Field{"black_share", &FlowReport::black_share, {.doc = "share of the area that is black film"}},
      Field{"fastest_m_s", &FlowReport::fastest_m_s, {.unit = "m/s", .doc = "largest speed across an edge"}},
      Field{"courant", &FlowReport::courant, {.doc = "most cells that the film crossed in one step"}},
      Field{"shortest_step_s", &FlowReport::shortest_step_s, {.unit = "s", .doc = "shortest step"}},
      Field{"longest_step_s", &FlowReport::longest_step_s, {.unit = "s", .doc = "longest step"}},
      Field{"steps", &FlowReport::steps, {.doc = "steps"}},
      Field{"iterations", &FlowReport::iterations, {.doc = "iterations of the Marangoni solver"}},
      Field{"repeated", &FlowReport::repeated, {.doc = "steps that were taken back and made shorter"}}};
}

}  // namespace shabon::film
