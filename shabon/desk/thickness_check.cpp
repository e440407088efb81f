#include "shabon/desk/thickness_check.h"

#include <string>

#include "shabon/base/text.h"

namespace shabon::desk {

Status check_unknowns(const UnknownFilm& film, std::size_t most) {
  const auto refuse = [](const std::string& message) { return fail(Failure::content, message); };
  if (film.unknowns.empty()) return refuse("expected a layer of unknown thickness, got none");
  if (film.unknowns.size() > most)
    return refuse("expected at most " + std::to_string(most) + " unknown thicknesses, got " +
                  std::to_string(film.unknowns.size()));
  std::vector<bool> taken(film.stack.layers.size(), false);
  for (const Unknown& unknown : film.unknowns) {
    if (unknown.layers.empty()) return refuse("expected a layer for every unknown thickness, got none");
    for (const std::size_t layer : unknown.layers) {
      if (layer >= taken.size())
        return refuse("there is no layer " + std::to_string(layer + 1) + ": the stack has " +
                      std::to_string(taken.size()));
      if (taken[layer]) return refuse("layer " + std::to_string(layer + 1) + " has two unknown thicknesses");
      taken[layer] = true;
    }
    if (!(unknown.low_nm >= 0 && unknown.low_nm < unknown.high_nm && unknown.high_nm <= optics::largest_thickness_nm))
      return refuse("expected a range of thickness that rises within 0.." +
                    format_number(optics::largest_thickness_nm) + " nm, got " + format_number(unknown.low_nm) + ".." +
                    format_number(unknown.high_nm));
  }
  return Done{};
}

}  // namespace shabon::desk
