#include "shabon/desk/reference_texts.h"

#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/desk/reference_films.h"
#include "shabon/io/csv.h"

namespace shabon::desk {

namespace {

constexpr std::string_view light_licence =
    "CC BY-SA 4.0 (https://creativecommons.org/licenses/by-sa/4.0/); the CIE does not endorse this project";
constexpr std::string_view tables_licence = "Apache-2.0";

std::string first_lines(std::string_view what, std::string_view program_version) {
  return std::string(reference_marker) + ", version " + std::to_string(reference_tables_version) + ": " +
         std::string(what) + "\n# written by shabon " + std::string(program_version) + "\n";
}

// What the film is, and the sources of its media.
std::string film_lines(const ReferenceFilm& film) {
  return "# film: " + std::string(film.title) + "\n# stack: " + reference_formula(film) +
         ", from the side the light comes from; d is thickness_nm\n" + media_lines(media_of(reference_stack(film))) +
         "#   n and k at every nanometre: media.csv\n";
}

constexpr std::string_view angle_line = "# angle_deg: of incidence, from the normal, in the first medium\n";

std::string lamp_names(std::string_view between) {
  std::string text;
  for (const std::string_view lamp : reference_lamps)
    text += (text.empty() ? "" : std::string(between)) + std::string(lamp);
  return text;
}

}  // namespace

std::string spectra_head(const ReferenceFilm& film, std::string_view program_version) {
  return first_lines(std::string(film.name) + ", spectra", program_version) + film_lines(film) +
         "# wavelength_nm: in vacuum\n" + std::string(angle_line) +
         "# R_s, R_p, T_s, T_p: shares of the incident power, reflected and transmitted into the last medium; s is "
         "perpendicular to the plane of incidence, p in it; 17 significant digits\n"
         "# licence: " +
         std::string(tables_licence) + "\nwavelength_nm,angle_deg,thickness_nm,R_s,R_p,T_s,T_p\n";
}

std::string colors_head(const ReferenceFilm& film, std::string_view program_version) {
  return first_lines(std::string(film.name) + ", colours", program_version) + film_lines(film) +
         "# lamp: " + lamp_names(", ") + "; observer: CIE 1931, 2 degrees; both at every nanometre: light.csv\n" +
         "# side: reflected, or transmitted into the last medium; unpolarised light, (s + p)/2\n" +
         std::string(angle_line) +
         "# X, Y, Z: sum S R xbar / sum S ybar and so on, plain sums over 360, 361, ... 830 nm; a perfect reflector "
         "has "
         "Y = 1; no chromatic adaptation; 17 significant digits\n"
         "# linear_r, linear_g, linear_b: linear sRGB of that XYZ by the full-precision matrix, unclipped, may be "
         "negative or above 1\n"
         "# hex: clipped to 0..1, encoded by IEC 61966-2-1, 8 bits\n"
         "# licence: " +
         std::string(tables_licence) + "\nlamp,side,angle_deg,thickness_nm,X,Y,Z,linear_r,linear_g,linear_b,hex\n";
}

std::string media_head(std::string_view program_version) {
  return first_lines("media", program_version) +
         "# wavelength_nm: in vacuum; n_NAME, k_NAME: n + ik of the medium, k > 0 absorbs; 17 significant digits\n" +
         media_lines(reference_media()) + "# licence: " + std::string(tables_licence) + "\n";
}

std::string light_head(std::string_view program_version) {
  std::string head = first_lines("light", program_version) + "# " + lamp_names(", ") +
                     ": relative power per nm of the lamps; xbar, ybar, zbar: the CIE 1931 observer, 2 degrees\n";
  for (const std::string_view lamp : reference_lamps)
    head += "# lamp " + std::string(lamp) + ": " + color::find_illuminant(lamp)->source + "\n";
  return head + "# observer: " + std::string(color::observer_1931().source) +
         "\n# licence: " + std::string(light_licence) + "\n";
}

std::string index_text(std::span<const ReferenceFile> files, std::string_view program_version) {
  std::string text = first_lines("index", program_version) + "file,rows,bytes,content\n";
  for (const ReferenceFile& file : files) {
    if (file.name == "index.csv") break;
    text += file.name + "," + std::to_string(file.rows) + "," + std::to_string(file.text.size()) + "," + '"' +
            file.description + "\"\n";
  }
  return text;
}

std::string readme_text(std::span<const ReferenceFile> files, std::string_view program_version) {
  std::string text(reference_marker);
  text += "\n\nVersion " + std::to_string(reference_tables_version) + ", written by shabon " +
          std::string(program_version) +
          ".\n\nWhat standard films reflect and transmit, and their colours, to test other programs against. All "
          "numbers are computed in\ndouble precision: every internal reflection, both polarisations, dispersion and "
          "absorption.\n\n| file | rows | content |\n|---|---|---|\n";
  for (const ReferenceFile& file : files) {
    if (file.name == "README.md") break;
    text += "| " + file.name + " | " + std::to_string(file.rows) + " | " + file.description + " |\n";
  }
  text +=
      "\n- Lines that begin with `#` say what the columns hold, in which units, and where the indices come from.\n"
      "- Wavelengths are in vacuum. Angles are measured from the normal in the first medium. s is perpendicular to "
      "the\n"
      "  plane of incidence. R and T are shares of the incident power; n + ik absorbs where k > 0.\n"
      "- Colours: plain sums at 1 nm over 360..830 nm with the lamps and the observer of `light.csv`; a perfect "
      "reflector\n  has Y = 1; nothing is adapted; linear sRGB is unclipped.\n"
      "- With `media.csv` and `light.csv` every number can be computed again without any other source. Indices "
      "between\n"
      "  whole nanometres are not needed.\n"
      "- Two correct programs agree within 1e-10 in R, T and XYZ. A program in single precision agrees within about "
      "1e-5.\n"
      "- Licences: " +
      std::string(tables_licence) + "; `light.csv` " + std::string(light_licence) + ".\n";
  return text;
}

}  // namespace shabon::desk
