#include "shabon/api/nk_join.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace shabon::api {

namespace {

// Linear in wavelength, equation (38); beyond its ends a table holds its end value.
double interpolated(const std::vector<NkSample>& table, double wavelength_nm) {
  const auto next = std::lower_bound(table.begin(), table.end(), wavelength_nm,
                                     [](const NkSample& sample, double nm) { return sample.wavelength_nm < nm; });
  if (next == table.begin()) return table.front().value;
  if (next == table.end()) return table.back().value;
  const NkSample &a = *(next - 1), &b = *next;
  return a.value + (b.value - a.value) * ((wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm));
}

// All wavelengths of both tables: between them n and k are straight lines, so nothing is lost.
std::vector<double> joint_wavelengths_nm(const std::vector<NkSample>& n, const std::vector<NkSample>& k) {
  std::vector<double> wavelengths_nm;
  for (const NkSample& sample : n) wavelengths_nm.push_back(sample.wavelength_nm);
  for (const NkSample& sample : k) wavelengths_nm.push_back(sample.wavelength_nm);
  std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
  wavelengths_nm.erase(std::unique(wavelengths_nm.begin(), wavelengths_nm.end()), wavelengths_nm.end());
  return wavelengths_nm;
}

}  // namespace

Result<optics::Medium> joined_table(const std::vector<NkSample>& n, const std::vector<NkSample>& k,
                                    optics::MediumDescription description) {
  std::vector<optics::IndexSample> rows;
  for (const double nm : joint_wavelengths_nm(n, k))
    rows.push_back({nm, interpolated(n, nm), k.empty() ? 0 : interpolated(k, nm)});
  std::optional<optics::WavelengthRange> both;
  if (!k.empty())
    both = {std::max(n.front().wavelength_nm, k.front().wavelength_nm),
            std::min(n.back().wavelength_nm, k.back().wavelength_nm)};
  return optics::Medium::table(std::move(rows), std::move(description), both);
}

}  // namespace shabon::api
