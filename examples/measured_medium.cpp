// A medium of one's own: n and k from a file (wavelengths in nm; a YAML file of refractiveindex.info will do as well),
// named in the stack as file:PATH. Usage: measured_medium FILE.
#include <cstdio>

#include "shabon/api/shabon.h"

using namespace shabon;

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: measured_medium FILE\n", stderr), 2;
  const std::string expression = "air | file:\"" + std::string(argv[1]) + "\" 250nm | water";
  const auto film = optics::parse_stack(expression, api::medium_resolver());
  if (!film) return std::fputs(to_text(film.errors()).c_str(), stderr), 3;

  const double wavelengths_nm[] = {400, 450, 500, 550};
  std::fputs(to_text(desk::range_warnings(*film, wavelengths_nm)).c_str(), stderr);  // beyond what was measured
  const double incidence_deg[] = {0, 60};
  const auto table = desk::film_table(*film, optics::Interference::airy, incidence_deg, wavelengths_nm);
  if (!table) return std::fputs(to_text(table.errors()).c_str(), stderr), 3;
  for (std::size_t a = 0; a < table->incidence_deg.size(); ++a) {
    for (std::size_t w = 0; w < table->wavelengths_nm.size(); ++w) {
      std::printf("%2g degrees, %g nm:", table->incidence_deg[a], table->wavelengths_nm[w]);
      for (const desk::FilmColumn& column : table->columns)
        std::printf(" %s %.5f", column.name.c_str(), column.values[table->row(a, w)]);
      std::printf("\n");
    }
  }
}
