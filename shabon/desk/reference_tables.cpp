#include "shabon/desk/reference_tables.h"

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/reference_films.h"
#include "shabon/desk/reference_texts.h"
#include "shabon/optics/reference/stack_model.h"

namespace shabon::desk {

namespace {

void add_cells(std::string& row, std::initializer_list<double> values) {
  for (const double value : values) row += "," + format_exact(value);
}

// A film at many wavelengths, its media looked up once.
class ResolvedFilm {
 public:
  ResolvedFilm(const ReferenceFilm& film, std::vector<double> wavelengths_nm)
      : layer_(film.layer), wavelengths_nm_(std::move(wavelengths_nm)) {
    const optics::Stack stack = reference_stack(film);
    for (const double nm : wavelengths_nm_) stacks_.push_back(optics::resolve(stack, nm));
  }

  std::vector<optics::Powers> powers(double thickness_nm, double incidence_deg) const {
    const optics::Incidence incidence = optics::incidence_from(Degrees(incidence_deg));
    std::vector<optics::Powers> powers;
    for (std::size_t i = 0; i < stacks_.size(); ++i) {
      optics::ResolvedStack stack = stacks_[i];
      stack.layers[layer_].thickness_nm = thickness_nm;
      powers.push_back(optics::model_powers(stack, optics::Interference::airy, incidence, wavelengths_nm_[i]));
    }
    return powers;
  }

 private:
  std::size_t layer_;
  std::vector<double> wavelengths_nm_;
  std::vector<optics::ResolvedStack> stacks_;
};

// The rows of every angle and, within it, of every thickness.
template <class Rows>
std::string all_rows(const std::vector<double>& thicknesses_nm, const Rows& rows) {
  const std::size_t thicknesses = thicknesses_nm.size();
  std::vector<std::string> parts(reference_angles_deg.size() * thicknesses);
  parallel_for(parts.size(), 0, [&](std::size_t i) {
    parts[i] = rows(reference_angles_deg[i / thicknesses], thicknesses_nm[i % thicknesses]);
  });
  std::string text;
  for (const std::string& part : parts) text += part;
  return text;
}

std::string spectra_rows(const ReferenceFilm& film) {
  const std::vector<double> wavelengths_nm = reference_wavelengths_nm();
  const ResolvedFilm resolved(film, wavelengths_nm);
  return all_rows(film.spectra_thicknesses_nm, [&](double incidence_deg, double thickness_nm) {
    const std::vector<optics::Powers> powers = resolved.powers(thickness_nm, incidence_deg);
    std::string rows;
    for (std::size_t i = 0; i < powers.size(); ++i) {
      rows += format_number(wavelengths_nm[i]) + "," + format_number(incidence_deg) + "," + format_number(thickness_nm);
      add_cells(rows, {powers[i].R_s, powers[i].R_p, powers[i].T_s, powers[i].T_p});
      rows += "\n";
    }
    return rows;
  });
}

std::vector<Side> sides_of(const ReferenceFilm& film) {
  return film.transmits ? std::vector{Side::reflected, Side::transmitted} : std::vector{Side::reflected};
}

std::string color_cells(const color::Spectrum& share, const color::Illuminant& lamp) {
  const color::Xyz xyz = color::reflectance_to_xyz(share, lamp);
  const color::LinearRgb rgb = color::xyz_to_linear_srgb(xyz);
  std::string cells;
  add_cells(cells, {xyz.x, xyz.y, xyz.z, rgb.r, rgb.g, rgb.b});
  return cells + "," + color::to_hex(color::encode_srgb(rgb));
}

std::string colors_rows(const ReferenceFilm& film) {
  std::vector<double> wavelengths_nm;
  for (std::size_t i = 0; i < color::spectrum_size; ++i) wavelengths_nm.push_back(color::wavelength_nm(i));
  const ResolvedFilm resolved(film, wavelengths_nm);
  return all_rows(reference_thicknesses_nm(film), [&](double incidence_deg, double thickness_nm) {
    const std::vector<optics::Powers> powers = resolved.powers(thickness_nm, incidence_deg);
    std::string rows;
    for (const Side side : sides_of(film)) {
      color::Spectrum share{};
      for (std::size_t i = 0; i < share.size(); ++i) share[i] = unpolarised(powers[i], side);
      for (const std::string_view lamp : reference_lamps)
        rows += std::string(lamp) + (side == Side::reflected ? ",reflected," : ",transmitted,") +
                format_number(incidence_deg) + "," + format_number(thickness_nm) +
                color_cells(share, *color::find_illuminant(lamp)) + "\n";
    }
    return rows;
  });
}

std::string media_rows() {
  const std::vector<optics::Medium> media = reference_media();
  std::string text = "wavelength_nm";
  for (const optics::Medium& medium : media) text += ",n_" + medium.name() + ",k_" + medium.name();
  text += "\n";
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    const double nm = color::wavelength_nm(i);
    text += format_number(nm);
    for (const optics::Medium& medium : media) add_cells(text, {medium.index(nm).real(), medium.index(nm).imag()});
    text += "\n";
  }
  return text;
}

std::string light_rows() {
  std::string text = "wavelength_nm";
  for (const std::string_view lamp : reference_lamps) text += "," + std::string(lamp);
  text += ",xbar,ybar,zbar\n";
  const color::Observer& observer = color::observer_1931();
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    text += format_number(color::wavelength_nm(i));
    for (const std::string_view lamp : reference_lamps) add_cells(text, {color::find_illuminant(lamp)->power[i]});
    add_cells(text, {observer.x[i], observer.y[i], observer.z[i]});
    text += "\n";
  }
  return text;
}

std::size_t spectra_count(const ReferenceFilm& film) {
  return reference_angles_deg.size() * film.spectra_thicknesses_nm.size() * reference_wavelengths_nm().size();
}

std::size_t colors_count(const ReferenceFilm& film) {
  return reference_angles_deg.size() * reference_thicknesses_nm(film).size() * sides_of(film).size() *
         reference_lamps.size();
}

std::string named(const ReferenceFilm& film, std::string_view kind) {
  return std::string(film.name) + "-" + std::string(kind) + ".csv";
}

}  // namespace

std::vector<ReferenceFile> reference_list() {
  std::vector<ReferenceFile> list;
  for (const ReferenceFilm& film : reference_films()) {
    const std::string title(film.title);
    list.push_back({named(film, "spectra"), "R and T of s and p: " + title, spectra_count(film), {}});
    list.push_back({named(film, "colors"), "XYZ and sRGB: " + title, colors_count(film), {}});
  }
  list.push_back({"media.csv", "n and k of the media at 1 nm", color::spectrum_size, {}});
  list.push_back({"light.csv", "the lamps and the observer at 1 nm", color::spectrum_size, {}});
  list.push_back({"index.csv", "the list of the tables", list.size(), {}});
  list.push_back({"README.md", "how the tables are meant", 0, {}});
  return list;
}

std::vector<ReferenceFile> reference_files(std::string_view program_version) {
  std::vector<ReferenceFile> files = reference_list();
  auto next = files.begin();
  for (const ReferenceFilm& film : reference_films()) {
    (next++)->text = spectra_head(film, program_version) + spectra_rows(film);
    (next++)->text = colors_head(film, program_version) + colors_rows(film);
  }
  (next++)->text = media_head(program_version) + media_rows();
  (next++)->text = light_head(program_version) + light_rows();
  (next++)->text = index_text(files, program_version);
  next->text = readme_text(files, program_version);
  return files;
}

}  // namespace shabon::desk
