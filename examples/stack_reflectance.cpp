// A dielectric mirror in front of silver: what it reflects, transmits and absorbs, for s and p, with what each layer
// takes, and psi and Delta as an ellipsometer would read them.
#include <cstdio>

#include "shabon/api/shabon.h"

using namespace shabon;

int main() {
  const auto mirror = optics::parse_stack("air | (ZnS 58nm | MgF2 99nm)^3 | Ag 40nm | glass");
  if (!mirror) return std::fputs(to_text(mirror.errors()).c_str(), stderr), 3;

  const optics::Incidence incidence = optics::incidence_from(30_deg);
  for (const double wavelength_nm : {450.0, 550.0, 650.0}) {
    const optics::StackPowers all = optics::stack_powers(*mirror, incidence, wavelength_nm);
    const optics::Ellipsometry angles =
        optics::ellipsometry(optics::stack_amplitudes(*mirror, incidence, wavelength_nm));
    std::printf("%g nm: R_s %.6f R_p %.6f T_s %.6f T_p %.6f, silver absorbs %.6f of s; psi %.3f Delta %.3f\n",
                wavelength_nm, all.powers.R_s, all.powers.R_p, all.powers.T_s, all.powers.T_p, all.A_s.back(),
                angles.psi_deg, angles.delta_deg);
  }
}
