#include "shabon/desk/kernel/sweep_rows.h"

#include <algorithm>
#include <array>

#include "shabon/math/packet.h"
#include "shabon/math/packet_math.h"
#include "shabon/math/packet_sum.h"

namespace shabon::desk {

namespace {

constexpr int lanes = 8;
static_assert(sweep_row_multiple % lanes == 0);
using P = math::packet<double, lanes>;

P at(const std::vector<double>& row, std::size_t first) { return P::load(&row[first]); }

// Which of the terms of (46) a loop needs: the compiler leaves out the others.
template <bool Transmitted, bool Lossless, bool Normal>
struct Form {};

// kept and lost, cos(phi) and sin(phi) at one thickness.
struct Passage {
  P cosine, sine, kept, lost;
};

template <bool Lossless>
Passage passage(P half_turns, P halvings_per_nm, double thickness_nm) {
  const P f = half_turns - math::round(half_turns);  // a whole half turn changes both signs, and (46) squares them
  Passage result{math::cos_pi_reduced(f), math::sin_pi_reduced(f), P(1.0), P(0.0)};
  if constexpr (!Lossless) {
    result.lost = -math::exp2_minus_1(-(halvings_per_nm * thickness_nm));
    result.kept = 1.0 - result.lost;
  }
  return result;
}

// (46) at N wavelengths.
struct Square {
  P gap, far, cosine, sine;
  Square(const SquareRows& rows, std::size_t first)
      : gap(at(rows.gap, first)),
        far(at(rows.far, first)),
        cosine(at(rows.cosine, first)),
        sine(at(rows.sine, first)) {}

  template <bool Lossless>
  P value(const Passage& by) const {
    const P turning = cosine * by.cosine + sine * by.sine;
    if constexpr (Lossless) return gap * gap + turning * turning;
    const P still = gap + far * by.lost;
    return still * still + by.kept * (turning * turning);
  }
};

struct Share {
  P part, whole;  // part/whole of the light
};

template <bool Transmitted>
struct Polarisation {
  Square incident, reflected;
  P passed;
  Polarisation(const PolarisationRows& rows, std::size_t first)
      : incident(rows.incident, first), reflected(rows.reflected, first), passed(at(rows.passed, first)) {}

  template <bool Lossless>
  Share share(const Passage& by) const {
    return {Transmitted ? passed * by.kept : reflected.template value<Lossless>(by),
            incident.template value<Lossless>(by)};
  }
};

// The wavelengths first..first+lanes of the table.
template <bool Transmitted, bool Lossless, bool Normal>
class Wavelengths {
 public:
  Wavelengths(const SweepTable& table, std::size_t first)
      : half_turns_per_nm_(at(table.half_turns_per_nm, first)),
        halvings_per_nm_(at(table.halvings_per_nm, first)),
        s_(table.s, first),
        p_(table.p, first) {}

  P share(double thickness_nm) const { return share_at(half_turns_per_nm_ * thickness_nm, thickness_nm); }

  // The mean over `fringes` fringes around the thickness, half of them to either side.
  P mean_share(double thickness_nm, P fringes) const {
    const P middle = half_turns_per_nm_ * thickness_nm;
    P sum(0.0);
    for (int i = 0; i < looks_at_fringes; ++i)
      sum += share_at(middle + fringes * ((i + 0.5) / looks_at_fringes - 0.5), thickness_nm);
    return sum * (1.0 / looks_at_fringes);
  }

 private:
  P share_at(P half_turns, double thickness_nm) const {
    const Passage by = passage<Lossless>(half_turns, halvings_per_nm_, thickness_nm);
    const Share s = s_.template share<Lossless>(by);
    if constexpr (Normal) return s.part * math::reciprocal(s.whole);
    const Share p = p_.template share<Lossless>(by);
    // One division for both.
    return 0.5 * (s.part * p.whole + p.part * s.whole) * math::reciprocal(s.whole * p.whole);
  }

  P half_turns_per_nm_, halvings_per_nm_;
  Polarisation<Transmitted> s_, p_;
};

// Calls task with a Wavelengths of the form that the table needs.
template <class Task>
void in_form(const SweepTable& table, Side side, const Task& task) {
  const auto normal = [&]<bool Transmitted, bool Lossless>(Form<Transmitted, Lossless, false>) {
    if (table.normal_incidence)
      task.template operator()<Wavelengths<Transmitted, Lossless, true>>();
    else
      task.template operator()<Wavelengths<Transmitted, Lossless, false>>();
  };
  const auto lossless = [&]<bool Transmitted>(Form<Transmitted, false, false>) {
    if (table.lossless)
      normal(Form<Transmitted, true, false>{});
    else
      normal(Form<Transmitted, false, false>{});
  };
  if (side == Side::transmitted)
    lossless(Form<true, false, false>{});
  else
    lossless(Form<false, false, false>{});
}

}  // namespace

void sweep_row(const SweepTable& table, Side side, double thickness_nm, std::span<double> row) {
  in_form(table, side, [&]<class Form>() {
    for (std::size_t first = 0; first < table.padded; first += lanes)
      Form(table, first).share(thickness_nm).store(&row[first]);
  });
}

void sweep_row_means(const SweepTable& table, Side side, std::span<const double> fringes_per_nm, double most_fringes,
                     double thickness_nm, std::span<double> row) {
  in_form(table, side, [&]<class Form>() {
    for (std::size_t first = 0; first < table.padded; first += lanes) {
      const Form at_these(table, first);
      const P fringes = P::load(&fringes_per_nm[first]) * thickness_nm;
      if (math::largest(fringes) <= most_fringes) {
        at_these.share(thickness_nm).store(&row[first]);
        continue;
      }
      const P counted = select(fringes > P(many_fringes), P(1.0), fringes);
      at_these.mean_share(thickness_nm, select(fringes > P(most_fringes), counted, P(0.0))).store(&row[first]);
    }
  });
}

void sweep_xyz(const SweepTable& table, Side side, const XyzRows& weights, std::span<const double> thicknesses_nm,
               std::span<color::Xyz> colours) {
  constexpr std::size_t tile = 32;  // thicknesses whose sums stay in the fastest memory
  in_form(table, side, [&]<class Form>() {
    for (std::size_t begin = 0; begin < thicknesses_nm.size(); begin += tile) {
      const std::size_t count = std::min(tile, thicknesses_nm.size() - begin);
      std::array<P, tile> x, y, z;
      for (std::array<P, tile>* sums : {&x, &y, &z}) sums->fill(P(0.0));
      for (std::size_t first = 0; first < table.padded; first += lanes) {
        const Form at_these(table, first);
        const P to_x = at(weights.x, first), to_y = at(weights.y, first), to_z = at(weights.z, first);
        for (std::size_t t = 0; t < count; ++t) {
          const P share = at_these.share(thicknesses_nm[begin + t]);
          x[t] += to_x * share, y[t] += to_y * share, z[t] += to_z * share;
        }
      }
      for (std::size_t t = 0; t < count; ++t) colours[begin + t] = {sum(x[t]), sum(y[t]), sum(z[t])};
    }
  });
}

}  // namespace shabon::desk
