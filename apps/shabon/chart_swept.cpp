#include "chart_swept.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "shabon/base/text.h"
#include "shabon/desk/retardation.h"
#include "shabon/desk/sweep.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr const char* default_stack = "air | water 0nm | air";
// More orders than that would be a comb; then every fifth, tenth, fiftieth ... is marked.
constexpr double most_single_orders = 30, most_marks = 15;
constexpr std::size_t most_orders_per_mark = 500'000'000;  // of a metre

std::string ordinal(std::size_t number) {
  const std::size_t tens = number % 100, ones = number % 10;
  const bool teen = tens >= 11 && tens <= 13;
  return std::to_string(number) + (teen ? "th" : ones == 1 ? "st" : ones == 2 ? "nd" : ones == 3 ? "rd" : "th");
}

// "250 nm", "80 um", "1 mm": in the unit that needs the fewest noughts.
std::string length_text(double nm) {
  constexpr double nm_per_um = 1e3, nm_per_mm = 1e6, least_in_um = 1e4;
  if (nm >= nm_per_mm) return format_number(nm / nm_per_mm, 6) + " mm";
  if (nm >= least_in_um) return format_number(nm / nm_per_um, 6) + " \u00B5m";
  return format_number(nm, 6) + " nm";
}

}  // namespace

Result<SweptFilm> read_swept_film(const ChartOptions& options) {
  SweptFilm film;
  film.expression = options.expression.value_or(default_stack);
  Result<optics::Stack> stack = read_stack({film.expression, options.interference_index});
  if (!stack) return stack.errors();
  film.stack = std::move(*stack);
  const std::size_t layers = film.stack.layers.size();
  if (layers == 0) return fail(Failure::usage, "STACK: expected a layer whose thickness can change, got none");
  if (layers > 1 && !options.layer)
    return fail(Failure::usage, fmt::format("--layer: expected which of the {} layers changes, from 1 to {}; got none",
                                            layers, layers));
  const long long chosen = options.layer.value_or(1);
  if (chosen > static_cast<long long>(layers))
    return fail(Failure::usage, fmt::format("--layer: expected a whole number from 1 to {}, got '{}'", layers, chosen));
  film.layer = static_cast<std::size_t>(chosen - 1);
  return film;
}

Diagnostics film_warnings(const SweptFilm& film, const std::vector<std::string>& notes) {
  Diagnostics warnings = desk::range_warnings(film.stack, std::vector<double>{color::first_nm, color::last_nm});
  for (const std::string& note : notes) warnings.push_back(warning_of(note));
  return warnings;
}

std::vector<desk::Side> shown_sides(const SweptFilm& film, const ChartOptions& options, std::size_t usual,
                                    std::vector<std::string>& notes) {
  std::vector<desk::Side> sides = chart_sides()[options.side_index.value_or(usual)].sides;
  const bool transmitted = std::find(sides.begin(), sides.end(), desk::Side::transmitted) != sides.end();
  if (transmitted && !options.side_index && !film.stack.exit.is_clear()) {
    std::erase(sides, desk::Side::transmitted);
    notes.push_back(fmt::format("Reflected light only: {} absorbs what enters it; '--side both' shows that share too.",
                                printable(film.stack.exit.name(), 40)));
    return sides;
  }
  for (const Diagnostic& note : power_notes(film.stack, transmitted)) notes.push_back(note.message + ".");
  return sides;
}

bool has_orders(const SweptFilm& film, const ChartOptions& options) {
  return film.stack.layers[film.layer].coherent && options.interference() != optics::Interference::none;
}

Result<std::vector<color::Xyz>> film_colors(const SweptFilm& film, const ChartOptions& options,
                                            const std::vector<double>& thicknesses_nm, double incidence_deg,
                                            desk::Side side) {
  desk::Sweep sweep;
  sweep.stack = film.stack;
  sweep.layer = film.layer;
  sweep.thicknesses_nm = thicknesses_nm;
  sweep.incidence = optics::incidence_from(Degrees(incidence_deg));
  sweep.side = side;
  sweep.interference = options.interference();
  return desk::swept_colors(sweep, options.lamp, options.observer());
}

double order_thickness_nm(const SweptFilm& film, double incidence_deg) {
  const optics::Incidence incidence = optics::incidence_from(Degrees(incidence_deg));
  const std::complex<double> n1 = film.stack.incidence.index(desk::order_retardation_nm);
  const std::complex<double> n2 = film.stack.layers[film.layer].medium.index(desk::order_retardation_nm);
  const std::complex<double> n2_cos = std::sqrt(n2 * n2 - n1 * n1 * incidence.sin_i * incidence.sin_i);
  return desk::order_retardation_nm / (2 * std::abs(n2_cos.real()));
}

std::size_t orders_per_mark(double order_length, double low, double high) {
  const double orders = (high - low) / order_length;
  if (!(orders > most_single_orders)) return 1;
  std::size_t step = 5;
  while (orders / static_cast<double>(step) > most_marks && step < most_orders_per_mark) step *= step % 10 == 5 ? 2 : 5;
  return step;
}

std::vector<io::ChartSpan> order_spans(double order_length, double low, double high) {
  std::vector<io::ChartSpan> spans;
  if (!(order_length > 0) || !std::isfinite(high / order_length)) return spans;
  const std::size_t step = orders_per_mark(order_length, low, high);
  const double mark_length = order_length * static_cast<double>(step);
  for (double mark = std::floor(low / mark_length); mark * mark_length < high; ++mark) {
    const auto before = static_cast<std::size_t>(mark) * step;
    // Of a mark at the edge, the orders that are within.
    const auto cut = [&](double nm) { return static_cast<std::size_t>(std::max(0.0, nm / order_length)); };
    const std::size_t first = std::max(before, cut(low)) + 1;
    const std::size_t last = std::max(first, std::min(before + step, cut(std::nextafter(high, 0.0)) + 1));
    io::ChartSpan& span = spans.emplace_back();
    span.low = mark * mark_length, span.high = (mark + 1) * mark_length;
    span.label = first == last ? ordinal(first) + " order" : fmt::format("orders {} to {}", first, last);
    span.short_label = first == last ? std::to_string(first) : fmt::format("{}\u2013{}", first, last);
  }
  return spans;
}

std::string thickness_label(const SweptFilm& film) {
  const std::string medium = printable(film.stack.layers[film.layer].medium.name(), 40);
  const std::string which = film.stack.layers.size() > 1 ? fmt::format("layer {}, {}", film.layer + 1, medium) : medium;
  return fmt::format("thickness d of the film: {} (nm)", which);
}

std::string title_text(const SweptFilm& film) {
  constexpr std::size_t most_layers = 6, most_letters = 80;
  if (film.stack.layers.size() > most_layers) return printable(film.expression, most_letters);
  std::string text = film.stack.incidence.name();
  for (std::size_t i = 0; i < film.stack.layers.size(); ++i) {
    const optics::Layer& layer = film.stack.layers[i];
    text += " | " + layer.medium.name() + (i == film.layer ? " d" : " " + length_text(layer.thickness_nm));
    if (!layer.coherent) text += " incoherent";
  }
  return printable(text + " | " + film.stack.exit.name(), most_letters);
}

}  // namespace shabon::app
