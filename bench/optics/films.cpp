#include "bench/optics/films.h"

#include <fmt/format.h>

#include "bench/micro.h"
#include "bench/optics/film_kernels.h"
#include "bench/scenes.h"

namespace shabon::bench {

namespace {

constexpr double seconds_each = 0.03;
constexpr double most_difference = 1e-5;  // of the mean reflectance; the plain loop in float has the largest

// One film and model in all its forms.
struct Film {
  std::string name;
  FilmPackets packets;
  PlainFilm<double> in_double;
  PlainFilm<float> in_float;
  bool exact;  // the Airy film, which has Stokes rows
  explicit Film(std::string label, const scene::Scene& scene)
      : name(std::move(label)),
        packets(scene),
        in_double(scene),
        in_float(scene),
        exact(scene.render.interference == optics::Interference::airy) {}
};

std::vector<Micro> loops_of(const Film& film, const FilmEvents& events) {
  const auto plain = [&](const auto& loop) {
    return [&] { return film.exact ? loop.airy(events) : loop.two_beam(events); };
  };
  constexpr double items = event_count * 16.0;
  std::vector<Micro> loops{{film.name + ", std::cos, double", plain(film.in_double), items},
                           {film.name + ", std::cos, float", plain(film.in_float), items},
                           {film.name + ", packets, powers", [&] { return film.packets.powers(events); }, items}};
  if (film.exact)
    loops.push_back({film.name + ", packets, Stokes rows", [&] { return film.packets.stokes_rows(events); }, items});
  return loops;
}

Status check(const std::vector<Micro>& loops) {
  const double expected = loops.front().run();
  for (const Micro& loop : loops) {
    const double got = loop.run();
    if (!(std::abs(got - expected) < most_difference))
      return fail(Failure::internal,
                  fmt::format("{}: expected the mean reflectance {}, got {}", loop.name, expected, got));
  }
  return Done{};
}

}  // namespace

Status bench_films(Report& report, int repetitions) {
  const struct {
    const char *name, *medium, *interference;
  } kinds[] = {{"two-beam, n = 1.333", "1.333", "two-beam"},
               {"two-beam, water", "water", "two-beam"},
               {"Airy, n = 1.333", "1.333", "airy"},
               {"Airy, water", "water", "airy"}};
  const FilmEvents events;
  std::vector<std::unique_ptr<Film>> films;
  std::vector<Micro> loops;
  std::vector<std::size_t> first_loop;
  for (const auto& kind : kinds) {
    const auto scene = plain_bubble(kind.medium, kind.interference);
    if (!scene) return scene.errors();
    films.push_back(std::make_unique<Film>(kind.name, *scene));
    const auto more = loops_of(*films.back(), events);
    if (const Status same = check(more); !same) return same;
    first_loop.push_back(loops.size());
    loops.insert(loops.end(), more.begin(), more.end());
  }
  const auto times = nanoseconds_per_item(loops, repetitions, seconds_each);
  for (std::size_t i = 0; i < loops.size(); ++i)
    report.record("optics", loops[i].name, "ns per film event and wavelength", times[i]);

  report.heading("Film events");
  report.paragraph(
      "Nanoseconds per film event and wavelength on one core: packets of 16 wavelengths as the renderer calls them,\n"
      "against plain loops with std::cos that compute the unpolarised reflectance, compiled with the same flags. "
      "Angles\n"
      "0 to 85 degrees, 150 to 900 nm. Water is dispersive. `Powers` are R and T of s and p; `Stokes rows` turn a row\n"
      "and multiply it by both Mueller blocks. Ratios: plain loop over packets.");
  Table table({"film", "std::cos, double", "std::cos, float", "powers", "ratio to double", "to float", "Stokes rows",
               "ratio to double"});
  const auto ratio = [](const Spread& a, const Spread& b) { return fmt::format("{:.1f}", a.median / b.median); };
  for (std::size_t i = 0; i < films.size(); ++i) {
    const Spread* t = &times[first_loop[i]];
    const bool rows = films[i]->exact;
    table.add({films[i]->name, shown(t[0], 1), shown(t[1], 1), shown(t[2], 2), ratio(t[0], t[2]), ratio(t[1], t[2]),
               rows ? shown(t[3], 2) : "", rows ? ratio(t[0], t[3]) : ""});
  }
  report.table(table);
  return Done{};
}

}  // namespace shabon::bench
