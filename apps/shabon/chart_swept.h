// A stack with one layer of many thicknesses, as the charts newton and angle show it.
#pragma once

#include <string>
#include <vector>

#include "chart.h"
#include "shabon/color/xyz.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/stack.h"

namespace shabon::app {

struct SweptFilm {
  std::string expression;
  optics::Stack stack;
  std::size_t layer = 0;  // index into stack.layers
};

// One side's strips, with the colours that they are made from.
struct SideColors {
  desk::Side side;
  std::vector<std::vector<color::Xyz>> colors;  // of every strip, and along it
  std::vector<double> factors;                  // of every strip
};

// More would not be told apart on a page.
inline constexpr std::size_t most_strips = 24;

// Errors: those of the expression; Failure::usage when it is not clear which layer is meant.
Result<SweptFilm> read_swept_film(const ChartOptions& options);

// What to say about media that are asked beyond their source, and these notes.
Diagnostics film_warnings(const SweptFilm& film, const std::vector<std::string>& notes = {});

// The colours at these thicknesses, nm.
Result<std::vector<color::Xyz>> film_colors(const SweptFilm& film, const ChartOptions& options,
                                            const std::vector<double>& thicknesses_nm, double incidence_deg,
                                            desk::Side side);

// The sides that a chart shows: those asked for, otherwise those of chart_sides()[usual], of which light transmitted
// into an absorbing medium is left out. `notes` gets what there is to say about them.
std::vector<desk::Side> shown_sides(const SweptFilm& film, const ChartOptions& options, std::size_t usual,
                                    std::vector<std::string>& notes);

// Whether the swept layer has orders: not where it is incoherent or no interference is computed.
bool has_orders(const SweptFilm& film, const ChartOptions& options);

// The thickness over which the path difference of neighbouring beams, 2 Re(n cos) times the thickness, grows by one
// order; n is that of the swept layer at order_retardation_nm. Infinite where the layer is beyond total reflection.
double order_thickness_nm(const SweptFilm& film, double incidence_deg);

// How many orders stand between two marks of a range, so that the marks stay apart: 1, or 5, 10, 50 and so on.
std::size_t orders_per_mark(double order_length, double low, double high);

// The orders that lie within the range of thickness; where there are many, several to a span.
std::vector<io::ChartSpan> order_spans(double order_length, double low, double high);

// "thickness d of the film: water (nm)", and for stacks of several layers which one it is.
std::string thickness_label(const SweptFilm& film);

// "air | water d | air"; a stack of many layers as it was written.
std::string title_text(const SweptFilm& film);

}  // namespace shabon::app
