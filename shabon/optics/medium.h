// A homogeneous isotropic medium: its complex refractive index n + ik as a function of the vacuum wavelength.
// Time factor e^(-iwt), so k > 0 absorbs.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/dispersion.h"

namespace shabon::optics {

// A range of vacuum wavelengths, both ends included.
struct WavelengthRange {
  double first_nm = 0;
  double last_nm = 0;
  friend bool operator==(const WavelengthRange&, const WavelengthRange&) = default;
};

// Of n, k and |n + ik|: far beyond any medium.
inline constexpr double smallest_index = 1e-4, largest_index = 1e4;

// The rendered range, down and up to which a dispersion formula is continued.
inline constexpr WavelengthRange rendered_range_nm = {360, 830};

// What a medium is called and where its numbers come from.
struct MediumDescription {
  std::string name;
  std::string description;
  std::string source;
};

// One measured row.
struct IndexSample {
  double wavelength_nm = 0;
  double n = 0;
  double k = 0;
  friend bool operator==(const IndexSample&, const IndexSample&) = default;
};

// One measured row of k alone, beside a formula for n.
struct AbsorptionSample {
  double wavelength_nm = 0;
  double k = 0;
  friend bool operator==(const AbsorptionSample&, const AbsorptionSample&) = default;
};

struct MixturePart;

// Glass and water measured over metres have a k of some 1e-8. With this one light loses 2 % over a millimetre; media
// of less count as clear where light comes from and where it goes.
inline constexpr double most_k_of_clear = 1e-6;

class Medium {
 public:
  Medium();  // vacuum

  // The same index at all wavelengths; its name is the number. n and k finite and >= 0, not both 0.
  static Medium constant(std::complex<double> index);
  static Medium constant(std::complex<double> index, MediumDescription description);

  // n by a formula that its source states for `range`, k by measured rows (none: lossless), both held at the ends of
  // what is known. Errors: a range that does not rise, a formula without an index of 0.0001..10000 somewhere in it,
  // rows as table() refuses them, no wavelength that has n and k.
  static Result<Medium> formula(DispersionFormula formula, WavelengthRange range, MediumDescription description,
                                std::vector<AbsorptionSample> absorption = {});

  // Measured rows, interpolated linearly in wavelength (38). Errors: no rows, wavelengths that are not positive and
  // rising, values that are not finite or above 10000, negative n or k, n and k both 0.
  // `range`: the wavelengths at which both n and k are known, where that is less than the rows cover.
  static Result<Medium> table(std::vector<IndexSample> rows, MediumDescription description,
                              std::optional<WavelengthRange> range = {});

  // By the rule of Lorentz and Lorenz (39), see mixing.h. Errors: no parts, fractions that do not sum to 1 within 1e-6.
  static Result<Medium> mixture(std::vector<MixturePart> parts, MediumDescription description);

  // n + ik at a vacuum wavelength. Outside its range a formula is continued down to 360 nm and up to 830 nm, or until
  // it runs into a resonance, and then holds its value; a table holds its end value; a mixture has what its parts have.
  std::complex<double> index(double wavelength_nm) const;

  // How the index is known: "constant", "formula", "table" or "mixture".
  std::string_view form() const;

  bool is_constant() const;
  bool is_lossless() const;  // k = 0 at every wavelength
  bool is_clear() const;     // k <= most_k_of_clear at 360, 361, ... 830 nm

  // The same n with k = 0; a mixture of such parts.
  Medium without_absorption() const;

  const std::string& name() const;
  const std::string& description() const;
  const std::string& source() const;

  // The wavelengths the source covers (all parts of a mixture); nothing for a constant.
  std::optional<WavelengthRange> range_nm() const;

  // False where index() continues or holds values beyond its source. Callers warn once.
  bool covers(double wavelength_nm) const;

  // One sentence for that warning, of what index() does at those of the wavelengths asked that the source does not
  // cover: "water: its source covers 182..1129 nm; above, the value at 1129 nm is held". Empty when it covers them all;
  // parts of at most 2 % of a mixture are not told.
  std::string outside_range_note(std::span<const double> wavelengths_nm) const;
  std::string outside_range_note(WavelengthRange asked) const;  // every wavelength of a range

  // Equal indices at all wavelengths by construction, whatever the names: air, vacuum and 1 are equal.
  friend bool operator==(const Medium& a, const Medium& b);

 private:
  struct Content;
  explicit Medium(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

struct MixturePart {
  Medium medium;
  double fraction = 0;  // of the volume, 0..1
  friend bool operator==(const MixturePart&, const MixturePart&) = default;
};

}  // namespace shabon::optics
