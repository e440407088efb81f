// n and k that were measured at wavelengths of their own, as one table.
#pragma once

#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::api {

struct NkSample {
  double wavelength_nm = 0, value = 0;
};

// Linear in wavelength (38) between the rows of each, at the wavelengths of both, so that nothing is lost; beyond its
// own ends each holds its end value, and the range is what both cover. `n` is not empty, wavelengths rise in both; no
// rows of k: lossless. Errors: those of Medium::table().
Result<optics::Medium> joined_table(const std::vector<NkSample>& n, const std::vector<NkSample>& k,
                                    optics::MediumDescription description);

}  // namespace shabon::api
