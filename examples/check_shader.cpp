// How far is a shader from the exact colours? Reads one of the tables that `shabon reference --out tables` writes and
// prints the CIEDE2000 differences of shader() below. Put your own formula there.
//
//   shabon reference --out tables
//   check_shader tables/free-film-1.333-colors.csv
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "shabon/api/shabon.h"

using namespace shabon;

namespace {

constexpr double pi = 3.14159265358979323846;

// The formula under test: what share of red, green and blue light a film in air reflects. Here the one of many soap
// bubble shaders: two walls by Schlick, all reflections, three wavelengths.
color::LinearRgb shader(double index, double thickness_nm, double cos_i) {
  const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (index * index));
  const double at_normal = std::pow((index - 1) / (index + 1), 2);
  const double wall = at_normal + (1 - at_normal) * std::pow(1 - cos_i, 5);
  const auto channel = [&](double wavelength_nm) {
    const double half_phase = 2 * pi * index * thickness_nm * cos_t / wavelength_nm;
    const double waves = 4 * wall * std::pow(std::sin(half_phase), 2);
    return waves / ((1 - wall) * (1 - wall) + waves);
  };
  return {channel(650), channel(510), channel(475)};
}

struct Differences {
  double sum = 0, largest = 0, at_nm = 0;
  int count = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: check_shader tables/free-film-1.333-colors.csv\n", stderr), 2;
  const Result<io::CsvTable> table = io::read_csv(argv[1]);
  if (!table) return std::fputs(to_text(table.errors()).c_str(), stderr), 4;
  const auto angle_deg = io::numbers(*table, "angle_deg"), thickness_nm = io::numbers(*table, "thickness_nm"),
             x = io::numbers(*table, "X"), y = io::numbers(*table, "Y"), z = io::numbers(*table, "Z");
  const auto lamp = table->column("lamp"), side = table->column("side");
  if (!angle_deg || !thickness_nm || !x || !y || !z || !lamp || !side)
    return std::fputs("expected a table of colours\n", stderr), 3;

  const color::Xyz white = color::white_point(*color::find_illuminant("D65"));
  std::map<double, Differences> by_angle;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const std::vector<io::CsvCell>& cells = table->rows[i].cells;
    if (cells[*lamp].text != "D65" || cells[*side].text != "reflected") continue;
    const double cos_i = std::cos((*angle_deg)[i] * pi / 180);
    const color::Xyz shaded = color::linear_srgb_to_xyz(shader(1.333, (*thickness_nm)[i], cos_i));
    const double difference =
        color::ciede2000(color::xyz_to_lab({(*x)[i], (*y)[i], (*z)[i]}, white), color::xyz_to_lab(shaded, white));
    Differences& all = by_angle[(*angle_deg)[i]];
    all.sum += difference;
    all.count += 1;
    if (difference > all.largest) all.largest = difference, all.at_nm = (*thickness_nm)[i];
  }
  std::printf("angle    mean dE2000   largest   at nm\n");
  for (const auto& [angle, all] : by_angle)
    std::printf("%5g %14.2f %9.2f %7g\n", angle, all.sum / all.count, all.largest, all.at_nm);
}
