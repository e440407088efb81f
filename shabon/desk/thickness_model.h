// A film with unknown thicknesses, and what it reflects and transmits at given ones: what an inverse problem asks for
// again and again, with the slopes that a fit needs (49).
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/layer_fields.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

inline constexpr std::size_t most_unknowns = 4;

// The layers that share one unknown thickness, and where it is looked for: 0 <= low < high <= largest_thickness_nm.
struct Unknown {
  std::vector<std::size_t> layers;  // indices into the stack's layers, of one medium
  double low_nm = 0, high_nm = 0;
};

struct UnknownFilm {
  optics::Stack stack;            // the thicknesses of the unknown layers are not used
  std::vector<Unknown> unknowns;  // 1..most_unknowns
};

// What a photometer measures: shares of the incident power.
enum class Quantity { R, R_s, R_p, T, T_s, T_p };

struct QuantityEntry {
  Quantity quantity;
  std::string_view name, description;
};

// All of them.
std::span<const QuantityEntry> quantities();

// Where a film is looked at.
struct ModelRow {
  double wavelength_nm = 0;  // in vacuum, > 0
  optics::Incidence incidence;
};

// Whether the light within an unknown layer interferes: not in an incoherent one.
bool has_fringes(const UnknownFilm& film, std::size_t unknown);

// Fringes of the path difference in an unknown layer, 2 |n cos| / wavelength, per nm of its thickness: the largest
// among the rows. Absorption counts as well: the wave then changes over the depth it reaches. In an incoherent layer
// absorption is all that counts.
double fringes_per_nm(const UnknownFilm& film, std::size_t unknown, std::span<const ModelRow> rows);

// Double precision; equal to film_powers() within 1e-10. Not for several threads at once: each takes a copy.
class FilmModel {
 public:
  // Unknown layers start with the thickness 0.
  FilmModel(const UnknownFilm& film, std::span<const ModelRow> rows, std::span<const Quantity> quantities);

  std::size_t unknowns() const { return film_.unknowns.size(); }
  std::size_t size() const { return rows_.size() * quantities_.size(); }  // of a result

  void set_thickness(std::size_t unknown, double thickness_nm);

  // Row after row, one value for each quantity.
  void shares(std::span<double> shares);
  // The same, and d share / d thickness per nm: size() values for each unknown, one unknown after the other.
  void shares_and_slopes(std::span<double> shares, std::span<double> slopes);

 private:
  using Complex = std::complex<double>;

  // What (31) makes of the fields at one face; known neighbours are multiplied up to one.
  struct Matrix {
    Complex ff = 1, fg = 0, gf = 0, gg = 1;
  };
  // One polarisation of one row.
  struct Side {
    Complex u1, u3;
    double decay = 1;           // of all known layers, with the scalings of their matrices
    std::vector<Matrix> known;  // from the exit
  };
  // An unknown layer at one row.
  struct Crossed {
    Complex n_c;
    optics::FieldRatios u;
    Complex n_squared;
    optics::FilmTerms terms;
  };
  struct Row {
    ModelRow at;
    Side s, p;
    std::vector<Crossed> unknowns;
  };
  // From the exit: a known block, or a layer of unknown thickness.
  struct Step {
    bool is_known = true;
    std::size_t index = 0;  // of the block or of the unknown
  };
  struct Shares;

  Row prepared(const ModelRow& at) const;
  void prepare_steps();
  template <bool WithSlopes>
  Shares side_shares(const Row& row, bool is_p) const;
  template <bool WithSlopes>
  void evaluate(std::span<double> shares, std::span<double> slopes) const;
  void evaluate_one_by_one(std::span<double> shares) const;
  void slopes_one_by_one(std::span<double> slopes);

  UnknownFilm film_;
  std::vector<Quantity> quantities_;
  std::vector<Row> rows_;
  std::vector<Step> steps_;
  bool needs_s_ = false, needs_p_ = false;
  bool one_by_one_ = false;  // by the reference: incoherent layers, grazing incidence, an absorbing first medium
};

}  // namespace shabon::desk
