#include "shabon/desk/reference_films.h"

#include <algorithm>

#include "shabon/base/text.h"
#include "shabon/color/spectrum.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {

std::span<const ReferenceFilm> reference_films() {
  static const std::vector<double> free_nm = {10, 100, 200, 300, 500, 750, 1000, 1500};
  static const std::vector<ReferenceFilm> films = {
      {"free-film-1.333", "a free film of constant index, for programs that know no dispersion",
       "air | 1.333 0nm | air", 0, free_nm, 1500, 10, true},
      {"soap-film", "a free soap film, taken as water with its dispersion", "air | water 0nm | air", 0, free_nm, 1500,
       10, true},
      {"oil-on-water", "a film of oleic acid on water", "air | oleic-acid 0nm | water", 0, free_nm, 1500, 10, true},
      {"oxide-on-silicon",
       "thermal oxide on silicon",
       "air | SiO2 0nm | Si",
       0,
       {0, 2, 50, 100, 200, 300, 500, 1000},
       1500,
       10,
       false},
      {"oxide-on-titanium",
       "anodised titanium",
       "air | TiO2 0nm | Ti",
       0,
       {0, 10, 25, 50, 75, 100, 150, 200},
       200,
       2,
       false},
      {"heat-tinted-steel",
       "iron under magnetite of many thicknesses and 10 nm of hematite",
       "air | Fe2O3 10nm | Fe3O4 0nm | Fe",
       1,
       {0, 5, 10, 20, 30, 50, 75, 100},
       100,
       1,
       false},
      {"coated-glass",
       "glass with one layer of magnesium fluoride",
       "air | MgF2 0nm | N-BK7",
       0,
       {0, 50, 75, 100, 125, 150, 200, 300},
       500,
       5,
       true},
      {"bragg-mirror",
       "a quarter-wave mirror for 550 nm on glass; its outermost layer takes all thicknesses, 58 nm is "
       "the mirror's own",
       "air | ZnS 0nm | (MgF2 99nm | ZnS 58nm)^5 | N-BK7",
       0,
       {0, 15, 29, 58, 87, 116, 145, 174},
       180,
       2,
       true},
  };
  return films;
}

optics::Stack reference_stack(const ReferenceFilm& film) {
  Result<optics::Stack> stack = optics::parse_stack(film.expression);
  return stack ? std::move(*stack) : optics::Stack{};  // a test reads every expression
}

std::string reference_formula(const ReferenceFilm& film) {
  std::string text(film.expression);
  const std::size_t at = text.find(" 0nm");
  return at == std::string::npos ? text : text.replace(at, 4, " d");
}

std::vector<double> reference_thicknesses_nm(const ReferenceFilm& film) {
  std::vector<double> thicknesses_nm;
  for (double nm = 0; nm <= film.last_nm; nm += film.step_nm) thicknesses_nm.push_back(nm);
  return thicknesses_nm;
}

std::vector<double> reference_wavelengths_nm() {
  std::vector<double> wavelengths_nm;
  for (int nm = reference_first_nm; nm <= reference_last_nm; nm += reference_step_nm) wavelengths_nm.push_back(nm);
  return wavelengths_nm;
}

std::vector<optics::Medium> media_of(const optics::Stack& stack) {
  std::vector<optics::Medium> media;
  const auto add = [&](const optics::Medium& medium) {
    if (std::find(media.begin(), media.end(), medium) == media.end()) media.push_back(medium);
  };
  add(stack.incidence);
  for (const optics::Layer& layer : stack.layers) add(layer.medium);
  add(stack.exit);
  return media;
}

std::vector<optics::Medium> reference_media() {
  std::vector<optics::Medium> media;
  for (const ReferenceFilm& film : reference_films())
    for (const optics::Medium& medium : media_of(reference_stack(film)))
      if (!medium.is_constant() && std::find(media.begin(), media.end(), medium) == media.end())
        media.push_back(medium);
  return media;
}

std::string media_lines(const std::vector<optics::Medium>& media) {
  constexpr optics::WavelengthRange used = {color::first_nm, color::last_nm};
  std::string lines;
  for (const optics::Medium& medium : media) {
    lines += "# medium " + medium.name() + ": ";
    if (medium.is_constant()) {
      lines += "index " + format_number(medium.index(used.first_nm).real()) + " at all wavelengths\n";
      continue;
    }
    lines += medium.description() + "; " + medium.source() + "\n";
    if (const std::string note = medium.outside_range_note(used); !note.empty()) lines += "#   " + note + "\n";
  }
  return lines;
}

}  // namespace shabon::desk
