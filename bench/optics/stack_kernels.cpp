#include "bench/optics/stack_kernels.h"

#include "shabon/math/packet_sum.h"
#include "shabon/optics/packet/stack.h"

namespace shabon::bench {

namespace {

using optics::StackRay;

constexpr int float_lanes = math::register_bytes / static_cast<int>(sizeof(float));
constexpr int double_lanes = math::register_bytes / static_cast<int>(sizeof(double));

template <class P>
void keep(const P& packet) {
  asm volatile("" : : "m"(packet));
}

// visit(first wavelength, ray) -> packet, summed.
template <class P, class Visit>
double mean_over(const StackCases& cases, const Visit& visit) {
  P sum(0);
  for (const double cos_i : cases.cos_i)
    for (std::size_t first = 0; first < cases.wavelengths_nm.size(); first += P::size)
      sum += visit(first, StackRay{.cos_i = cos_i});
  return static_cast<double>(math::sum(sum)) / static_cast<double>(cases.cos_i.size() * cases.wavelengths_nm.size());
}

template <class T>
double multiply_add(double& operations) {
  constexpr int lanes = math::register_bytes / static_cast<int>(sizeof(T)), independent = 12, rounds = 4096;
  using P = math::packet<T, lanes>;
  const P factor(T(0.999)), addend(T(1e-3));
  const auto add = [&](P& sum) {
    sum = sum * factor + addend;
#if defined(__AVX512F__)
    asm volatile("" : : "v"(sum.v));  // neither rewritten nor left out
#elif defined(__x86_64__)
    asm volatile("" : : "x"(sum.v));
#endif
  };
  const auto run = [&](auto... sums) {  // each a variable, so that it stays in a register
    for (int round = 0; round < rounds; ++round) (add(sums), ...);
    return math::sum((sums + ...));
  };
  operations = 2.0 * lanes * independent * rounds;
  return [&]<int... i>(std::integer_sequence<int, i...>) { return static_cast<double>(run(P(T(1 + i))...)); }
  (std::make_integer_sequence<int, independent>());
}

}  // namespace

struct StackPackets::Tables {
  const StackCases& cases;
  optics::StackTable table;
};

StackPackets::StackPackets(const StackCases& cases)
    : tables_(std::make_unique<Tables>(Tables{cases, {cases.stack, cases.wavelengths_nm}})) {}
StackPackets::~StackPackets() = default;

template <class T, int N>
math::packet<T, N> powers_sum(const optics::StackTable& table, std::size_t first, const StackRay& ray) {
  const auto sides = optics::cross_stack<T, N>(table, first, ray);
  const auto s = optics::powers_of(sides.s, sides.lossless), p = optics::powers_of(sides.p, sides.lossless);
  keep(s[1]), keep(p[1]);
  return s[0] + p[0];
}

double StackPackets::in_float() const {
  return mean_over<math::packet<float, float_lanes>>(tables_->cases, [&](std::size_t first, const StackRay& ray) {
    return powers_sum<float, float_lanes>(tables_->table, first, ray);
  });
}

double StackPackets::in_double() const {
  return mean_over<math::packet<double, double_lanes>>(tables_->cases, [&](std::size_t first, const StackRay& ray) {
    return powers_sum<double, double_lanes>(tables_->table, first, ray);
  });
}

double StackPackets::as_needed() const {
  return mean_over<math::packet<float, 16>>(tables_->cases, [&](std::size_t first, const StackRay& ray) {
    const auto powers = optics::stack_powers<16>(tables_->table, first, ray);
    keep(powers.T_s), keep(powers.T_p);
    return powers.R_s + powers.R_p;
  });
}

double StackPackets::stokes() const {
  return mean_over<math::packet<float, 16>>(tables_->cases, [&](std::size_t first, const StackRay& ray) {
    const auto rows = optics::stack_mueller<16>(tables_->table, first, ray);
    keep(rows);
    return 2.0f * rows.reflected.a;
  });
}

double StackPackets::share_in_double() const {
  if (tables_->table.layers.size() > optics::most_layers_in_float) return 1;
  double in_double = 0, packets = 0;
  for (const double cos_i : tables_->cases.cos_i)
    for (std::size_t first = 0; first < tables_->cases.wavelengths_nm.size(); first += float_lanes, ++packets)
      in_double += optics::needs_double(
          optics::cross_stack<float, float_lanes>(tables_->table, first, StackRay{.cos_i = cos_i}));
  return in_double / packets;
}

double multiply_add_float(double& operations) { return multiply_add<float>(operations); }
double multiply_add_double(double& operations) { return multiply_add<double>(operations); }

namespace {

// What every layer needs: 4 products with the sine, and for each polarisation 8 products and 4 sums for the fields.
constexpr double matrix = 4 + 2 * 12;
constexpr double rounding = 2 * 11;                   // the light inside, in float alone
constexpr double phase = 4;                           // one product, reduced by two sums and a difference
constexpr double sine_float = 12, cosine_float = 10;  // polynomials, the square shared
constexpr double sine_double = 16, cosine_double = 16;
constexpr double angle_in_double = 2;             // q^2, and thickness over wavelength
constexpr double roots_float = 7, to_double = 4;  // 1/q by one step of Newton's method, q; one step for q in double
constexpr double roots_double = 10;               // by two steps

}  // namespace

StackOperations operations_per_constant_layer() {
  return {2 * phase + sine_float + cosine_float + matrix + rounding, phase + sine_double + cosine_double + matrix};
}

StackOperations operations_per_dispersive_layer() {
  const StackOperations constant = operations_per_constant_layer();
  return {constant.in_float + roots_float + 2 * (angle_in_double + to_double),
          constant.in_double + roots_double + angle_in_double};
}

}  // namespace shabon::bench
