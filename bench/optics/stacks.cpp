#include "bench/optics/stacks.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/micro.h"
#include "bench/optics/stack_kernels.h"
#include "shabon/optics/media.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::bench {

namespace {

constexpr double seconds_each = 0.03;
constexpr double most_difference = 1e-5;  // of the mean of R_s + R_p
constexpr int angle_count = 256;          // 0 to 80 degrees
constexpr int wavelength_count = 16;
constexpr int reference_angle_step = 16;  // the reference computes every 16th angle
constexpr double million = 1e6;

using optics::Medium;

Medium dispersive(double n_violet, double n_red) {
  return *Medium::table({{360, n_violet, 0}, {830, n_red, 0}}, {"dispersive", "", ""});
}

// Layers of two media in turn, between 60 and 140 nm; the outer ones are air and glass.
StackCases cases_of(int layers, const Medium& a, const Medium& b, int angles) {
  StackCases cases;
  for (int j = 0; j < layers; ++j) cases.stack.layers.push_back({j % 2 ? b : a, 60.0 + 80.0 * j / layers, true});
  cases.stack.exit = Medium::constant(1.52);
  for (int i = 0; i < angles; ++i) cases.cos_i.push_back(std::cos(80.0 * i / angles * std::numbers::pi / 180));
  for (int i = 0; i < wavelength_count; ++i) cases.wavelengths_nm.push_back(375 + 29.375 * i);
  return cases;
}

double reference_mean(const StackCases& cases) {
  double sum = 0;
  std::size_t count = 0;
  optics::ResolvedStack resolved;
  for (const double nm : cases.wavelengths_nm) {
    optics::resolve(cases.stack, nm, resolved);
    for (std::size_t i = 0; i < cases.cos_i.size(); i += reference_angle_step, ++count) {
      const auto incidence = optics::incidence_from_cos(cases.cos_i[i]);
      const auto powers =
          optics::powers_of(optics::stack_amplitudes(resolved, incidence, nm), resolved.n1, resolved.n3, incidence);
      sum += powers.R_s + powers.R_p;
    }
  }
  return sum / static_cast<double>(count);
}

struct Kind {
  std::string name;
  StackCases cases;
  StackPackets packets;
  StackOperations operations;  // per layer; 0 where they are not counted
  Kind(std::string label, StackCases of, StackOperations counted = {0, 0})
      : name(std::move(label)), cases(std::move(of)), packets(cases), operations(counted) {}
  double items() const {
    return static_cast<double>(cases.cos_i.size() * cases.wavelengths_nm.size() * cases.stack.layers.size());
  }
};

std::vector<std::unique_ptr<Kind>> all_kinds() {
  const Medium low = Medium::constant(1.46), high = Medium::constant(2.1), silver = *optics::find_medium("Ag");
  const Medium low_d = dispersive(1.48, 1.45), high_d = dispersive(2.25, 2.05);
  std::vector<std::unique_ptr<Kind>> kinds;
  const auto add = [&](auto&&... of) { kinds.push_back(std::make_unique<Kind>(of...)); };
  for (const int layers : {1, 6, 10, 40})
    add(fmt::format("{} of n = 1.46 and 2.1", layers), cases_of(layers, high, low, angle_count),
        operations_per_constant_layer());
  add("10 dispersive", cases_of(10, high_d, low_d, angle_count), operations_per_dispersive_layer());
  add("10, every other silver", cases_of(10, low_d, silver, angle_count));
  return kinds;
}

// Per kind: reference, float, double, as needed, Stokes.
constexpr std::size_t loops_per_kind = 5;

std::vector<Micro> loops_of(const Kind& kind) {
  const double all = kind.items();
  return {{kind.name + ", reference", [&] { return reference_mean(kind.cases); }, all / reference_angle_step},
          {kind.name + ", float lanes", [&] { return kind.packets.in_float(); }, all},
          {kind.name + ", double lanes", [&] { return kind.packets.in_double(); }, all},
          {kind.name + ", as needed", [&] { return kind.packets.as_needed(); }, all},
          {kind.name + ", Mueller blocks", [&] { return kind.packets.stokes(); }, all}};
}

Status check(const std::vector<Micro>& loops) {
  const double expected = loops[2].run();  // in double
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (const double got = loops[i].run(); !(std::abs(got - expected) < most_difference))
      return fail(Failure::internal, fmt::format("{}: expected the mean {}, got {}", loops[i].name, expected, got));
  return Done{};
}

void report_kinds(Report& report, const std::vector<std::unique_ptr<Kind>>& kinds, const Spread* times,
                  const Spread peaks[2]) {
  Table table({"layers", "reference", "float lanes", "share of peak", "double lanes", "share of peak", "as needed",
               "in double", "reference over as needed", "Mueller blocks"});
  for (std::size_t i = 0; i < kinds.size(); ++i, times += loops_per_kind) {
    const Kind& kind = *kinds[i];
    const auto share = [&](double operations, const Spread& time, const Spread& peak) {
      return operations > 0 ? fmt::format("{:.0f} %", 100 * operations / time.median * peak.median) : std::string();
    };
    table.add({kind.name, shown(times[0], 0), shown(times[1], 2), share(kind.operations.in_float, times[1], peaks[0]),
               shown(times[2], 2), share(kind.operations.in_double, times[2], peaks[1]), shown(times[3], 2),
               fmt::format("{:.0f} %", 100 * kind.packets.share_in_double()),
               fmt::format("{:.0f}", times[0].median / times[3].median), shown(times[4], 2)});
  }
  report.table(table);
}

}  // namespace

Status bench_stacks(Report& report, int repetitions) {
  const auto kinds = all_kinds();
  std::vector<Micro> loops;
  for (const auto& kind : kinds) {
    const auto more = loops_of(*kind);
    if (const Status same = check(more); !same) return same;
    loops.insert(loops.end(), more.begin(), more.end());
  }
  // A million stacks of 10 layers, each at another angle or wavelength.
  const Kind many("10^6 stacks of 10 layers",
                  cases_of(10, dispersive(2.25, 2.05), dispersive(1.48, 1.45), int(million / wavelength_count)));
  const std::size_t million_at = loops.size();
  loops.push_back({many.name + ", as needed", [&] { return many.packets.as_needed(); }, 1e9});  // items: in seconds
  loops.push_back({many.name + ", double lanes", [&] { return many.packets.in_double(); }, 1e9});
  double operations[2];
  multiply_add_float(operations[0]), multiply_add_double(operations[1]);
  double ignored;
  loops.push_back({"multiply-adds, float", [&] { return multiply_add_float(ignored); }, operations[0]});
  loops.push_back({"multiply-adds, double", [&] { return multiply_add_double(ignored); }, operations[1]});
  const auto times = nanoseconds_per_item(loops, repetitions, seconds_each);
  const Spread* peaks = &times[million_at + 2];  // nanoseconds per operation
  for (std::size_t i = 0; i < million_at; ++i)
    report.record("optics", loops[i].name, "ns per wavelength, angle and layer", times[i]);
  report.heading("Stacks");
  report.paragraph(
      "Nanoseconds per wavelength, angle and layer on one core, R and T of s and p: the reference in double, one\n"
      "wavelength at a time, and packets of 16 wavelengths. Air, layers of two media in turn, glass; 0 to 80 degrees.\n"
      "`As needed` is what the renderer calls: float lanes, and double lanes where the light inside the stack asks "
      "for\n"
      "it ([decision 7](decisions/0007-stacks-in-float-or-double.md); `in double` is their share), within 5e-6 of "
      "double.\n"
      "`Mueller blocks` are both of (16), as needed.");
  report_kinds(report, kinds, times.data(), peaks);
  report.paragraph(fmt::format(
      "Share of peak: operations over time, as a share of what a loop of independent fused multiply-adds on the same\n"
      "registers reached in the same run, {:.0f} Gflop/s in float and {:.0f} in double. Counted are the additions and\n"
      "multiplications of the algebra, for each layer and wavelength and both polarisations: {:.0f} without dispersion "
      "and\n"
      "{:.0f} with it in float, of which those in double (angle and phase) count twice, and {:.0f} and {:.0f} in "
      "double. Table\n"
      "look-ups, conversions, loads and what is done once for a stack are not counted, but are in the time.",
      1 / peaks[0].median, 1 / peaks[1].median, operations_per_constant_layer().in_float,
      operations_per_dispersive_layer().in_float, operations_per_constant_layer().in_double,
      operations_per_dispersive_layer().in_double));
  const Spread &all = times[million_at], &exact = times[million_at + 1];
  report.record("optics", "10^6 stacks of 10 layers", "s", all);
  report.paragraph(
      fmt::format("10^6 stacks of 10 dispersive layers, R and T of s and p, one wavelength and angle each: "
                  "{} s as needed,\n{} s in double. {}.",
                  shown(all, 4), shown(exact, 4), verdict(all.median < 1, "Goal of 1 s")));
  return Done{};
}

}  // namespace shabon::bench
