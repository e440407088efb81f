// A homogeneous isotropic medium: its complex refractive index n + ik as a function of the vacuum wavelength.
// Time factor e^(-iwt), so k > 0 absorbs.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <string>
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

class Medium {
 public:
  Medium();  // vacuum

  // The same index at all wavelengths; its name is the number. n and k finite and >= 0, not both 0.
  static Medium constant(std::complex<double> index);
  static Medium constant(std::complex<double> index, MediumDescription description);

  // A lossless medium by a formula that its source states for `range`.
  static Medium formula(DispersionFormula formula, WavelengthRange range, MediumDescription description);

  // Measured rows, interpolated linearly in wavelength. Errors: no rows, wavelengths that are not positive and rising,
  // values that are not finite, negative n or k, n and k both 0.
  static Result<Medium> table(std::vector<IndexSample> rows, MediumDescription description);

  // n + ik at a vacuum wavelength. Outside its range a formula continues down to 360 nm and up to 830 nm and then holds
  // its value, a table holds its end value.
  std::complex<double> index(double wavelength_nm) const;

  bool is_constant() const;
  bool is_lossless() const;  // k = 0 at every wavelength

  const std::string& name() const;
  const std::string& description() const;
  const std::string& source() const;

  // The wavelengths the source covers; nothing for a constant.
  std::optional<WavelengthRange> range_nm() const;

  // False where index() continues or holds values beyond its source. Callers warn once.
  bool covers(double wavelength_nm) const;

  // One sentence for that warning: "water: wavelengths outside 182..1129 nm: the formula is continued".
  std::string outside_range_note() const;

  // Equal indices at all wavelengths by construction, whatever the names: air, vacuum and 1 are equal.
  friend bool operator==(const Medium& a, const Medium& b);

 private:
  struct Content;
  explicit Medium(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

}  // namespace shabon::optics
