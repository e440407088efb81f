// Thicknesses from colours that others computed or saw.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "shabon/desk/film_color.h"
#include "shabon/desk/sweep.h"
#include "shabon/desk/thickness_color.h"
#include "shabon/io/csv.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

UnknownFilm unknown_film(std::string_view expression, double high_nm) {
  const auto parsed = optics::parse_stack_with_unknowns(expression);
  EXPECT_TRUE(parsed.ok()) << expression;
  return {parsed->stack, {{parsed->unknowns.front().layers, 0, high_nm}}};
}

// The colours of an independent chain (tmm for the spectra, colour-science for the colours; the file names versions).
TEST(PublishedThickness, OfFilmsThatAnotherProgramColoured) {
  const std::map<std::string, const char*> stacks = {{"SiO2/Si", "air | SiO2 ? | Si"},
                                                     {"TiO2/Ti", "air | TiO2 ? | Ti"},
                                                     {"Oil/H2O", "air | biodiesel ? | water"},
                                                     {"Fe3O4/Fe", "air | Fe3O4 ? | Fe"}};
  const Result<io::CsvTable> table = io::read_csv(SHABON_TEST_DATA "/color/films_on_substrates_d65.csv");
  ASSERT_TRUE(table.ok());
  const auto thickness_nm = *io::numbers(*table, "d_nm");
  const auto x = *io::numbers(*table, "X"), y = *io::numbers(*table, "Y"), z = *io::numbers(*table, "Z");
  int films = 0;
  for (std::size_t i = 0; i < thickness_nm.size(); i += 2, ++films) {
    const std::string system = table->rows[i].cells[0].text;
    const ColorQuery query{unknown_film(stacks.at(system), 1000), {{{x[i], y[i], z[i]}}}};
    const Result<ColorAnswer> answer = thickness_from_color(query);
    ASSERT_TRUE(answer.ok()) << to_text(answer.errors());
    EXPECT_LT(answer->candidates.front().difference, 1e-3) << system << " " << thickness_nm[i];
    EXPECT_NEAR(answer->candidates.front().thickness_nm, thickness_nm[i], 0.01) << system;
  }
  EXPECT_GT(films, 20);
}

// A name and the CIELAB hues it is given to, degrees, from the first up to the second through 360.
struct Name {
  double thickness_nm;
  const char* name;
  double first_deg, last_deg;
};

// W. A. Pliskin, E. E. Conrad, "Nondestructive determination of thickness and refractive index of transparent films",
// IBM Journal of Research and Development 8 (1964) 43-51: oxide on silicon by eye, from above, under daylight
// fluorescent lamps. The names are theirs, the hues beside them ours. Names for no hue ("metallic", "tan") are left
// out. So is the pale end of the third order, above 520 nm: there the computed colours go from green to pink through
// grey, and an eye that has just seen the green calls the grey yellowish.
constexpr Name chart[] = {
    {100, "dark violet to red violet", 290, 10},
    {120, "royal blue", 230, 300},
    {150, "light blue to metallic blue", 200, 285},
    {200, "light gold or yellow", 70, 125},
    {220, "gold with slight yellow orange", 60, 100},
    {250, "orange to melon", 25, 80},
    {270, "red violet", 300, 20},
    {300, "blue to violet blue", 245, 315},
    {310, "blue", 230, 300},
    {320, "blue to blue green", 190, 280},
    {340, "light green", 140, 200},
    {350, "green to yellow green", 120, 180},
    {360, "yellow green", 105, 160},
    {370, "green yellow", 95, 140},
    {390, "yellow", 75, 115},
    {410, "light orange", 40, 90},
    {420, "carnation pink", 345, 60},
    {440, "violet red", 325, 20},
    {460, "red violet", 300, 360},
    {470, "violet", 290, 345},
    {480, "blue violet", 275, 325},
    {490, "blue", 225, 300},
    {500, "blue green", 170, 260},
    {520, "green (broad)", 130, 190},
};

double hue_deg(const color::Lab& lab) {
  const double deg = std::atan2(lab.b, lab.a) * 180 / std::numbers::pi;
  return deg < 0 ? deg + 360 : deg;
}

bool is_between(double deg, double first_deg, double last_deg) {
  return first_deg <= last_deg ? deg >= first_deg && deg <= last_deg : deg >= first_deg || deg <= last_deg;
}

// Their steps are 10 nm, and an eye's name for a hue has its width: each name fits within so much of its thickness.
TEST(PublishedThickness, OxideOnSiliconHasTheColoursOfTheChart) {
  constexpr double reading_nm = 10;
  const color::Illuminant& lamp = *color::find_illuminant("FL7");  // a daylight fluorescent lamp
  const color::Xyz white = color::white_point(lamp);
  for (const Name& entry : chart) {
    Sweep sweep{*optics::parse_stack("air | SiO2 1nm | Si"), 0, {}};
    for (double off_nm = -reading_nm; off_nm <= reading_nm; off_nm += 1)
      sweep.thicknesses_nm.push_back(entry.thickness_nm + off_nm);
    const auto colors = swept_colors(sweep, lamp);
    ASSERT_TRUE(colors.ok());
    bool fits = false;
    for (const color::Xyz& xyz : *colors)
      fits = fits || is_between(hue_deg(color::xyz_to_lab(xyz, white)), entry.first_deg, entry.last_deg);
    EXPECT_TRUE(fits) << entry.thickness_nm << " nm, " << entry.name << ": hue "
                      << hue_deg(color::xyz_to_lab((*colors)[10], white));
  }
}

}  // namespace
}  // namespace shabon::desk
