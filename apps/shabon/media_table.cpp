#include "media_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "json.h"
#include "media_list.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"

namespace shabon::app {

namespace {

std::string one_line(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

}  // namespace

std::string media_table_text(const MediaTable& table) {
  constexpr int column = 11;
  std::string text, names = fmt::format("{:>14}", ""), heads = fmt::format("{:>14}", "wavelength_nm");
  for (const optics::Medium& medium : table.media) {
    text += fmt::format("{}: {}, {}, {}\n", printable(medium.name()), printable(medium.description()), medium.form(),
                        range_text(medium));
    if (!trim(medium.source()).empty()) text += fmt::format("  {}\n", printable(one_line(medium.source())));
    names += fmt::format("  {:>{}}", printable(medium.name(), 2 * column + 1), 2 * column + 1);
    heads += fmt::format("  {:>{}} {:>{}}", "n", column, "k", column);
  }
  text += '\n' + (table.media.size() > 1 ? names + '\n' : "") + heads + '\n';
  for (const double wavelength_nm : table.wavelengths_nm) {
    text += fmt::format("{:>14}", format_number(wavelength_nm, 9));
    for (const optics::Medium& medium : table.media) {
      const std::complex<double> index = medium.index(wavelength_nm);
      text += fmt::format("  {:>{}.6f} {:>{}}", index.real(), column, format_number(index.imag(), 5), column);
    }
    text += '\n';
  }
  return text;
}

std::string media_table_csv(const MediaTable& table) {
  const bool several = table.media.size() > 1;
  std::string csv, heads = "wavelength_nm";
  for (const optics::Medium& medium : table.media) {
    csv += fmt::format("# {}: {}; {}; {}\n", one_line(medium.name()), one_line(medium.description()),
                       range_text(medium), one_line(medium.source()));
    heads += several ? "," + io::csv_cell("n " + medium.name()) + "," + io::csv_cell("k " + medium.name()) : ",n,k";
  }
  csv += heads + '\n';
  for (const double wavelength_nm : table.wavelengths_nm) {
    csv += format_number(wavelength_nm);
    for (const optics::Medium& medium : table.media) {
      const std::complex<double> index = medium.index(wavelength_nm);
      csv += "," + format_exact(index.real()) + "," + format_exact(index.imag());
    }
    csv += '\n';
  }
  return csv;
}

std::string media_table_json(const MediaTable& table) {
  std::string media;
  for (const optics::Medium& medium : table.media) {
    std::vector<double> n, k;
    for (const double wavelength_nm : table.wavelengths_nm) {
      n.push_back(medium.index(wavelength_nm).real());
      k.push_back(medium.index(wavelength_nm).imag());
    }
    JsonObject json;
    json.add("name", medium.name()).add("description", medium.description()).add("source", medium.source());
    json.add("form", medium.form()).add_json("range_nm", range_json(medium)).add("n", n).add("k", k);
    media += (media.empty() ? "\n    " : ",\n    ") + json.line();
  }
  return JsonObject().add("wavelength_nm", table.wavelengths_nm).add_json("media", "[" + media + "\n  ]").text();
}

}  // namespace shabon::app
