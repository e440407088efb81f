#include "media_list.h"

#include <fmt/format.h>

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/optics/media.h"

namespace shabon::app {

namespace {

constexpr double sodium_d_nm = 589.3;  // where refractive indices are usually quoted
constexpr int indent = 16;

std::string index_text(std::complex<double> index) {
  if (index.imag() == 0) return fmt::format("{:.5f}", index.real());
  return fmt::format("{:.5f}+{}i", index.real(), format_number(index.imag(), 4));
}

std::string alias_text(const optics::MediumEntry& entry, std::string_view separator) {
  std::string text;
  for (const std::string_view alias : entry.aliases)
    text += (text.empty() ? "" : std::string(separator)) + std::string(alias);
  return text;
}

}  // namespace

std::string range_text(const optics::Medium& medium) {
  const auto range = medium.range_nm();
  if (!range) return "all wavelengths";
  return format_number(range->first_nm, 6) + ".." + format_number(range->last_nm, 6) + " nm";
}

std::string range_json(const optics::Medium& medium) {
  const auto range = medium.range_nm();
  return range ? json_numbers({range->first_nm, range->last_nm}) : "null";
}

std::string media_list_text() {
  std::string text =
      fmt::format("{:<{}} {:<20} {:<9} {:<19} {}\n", "name", indent, "index at 589.3 nm", "by", "range", "what");
  for (const optics::MediumEntry& entry : optics::media_library()) {
    const optics::Medium& medium = entry.medium;
    text += fmt::format("{:<{}} {:<20} {:<9} {:<19} {}\n", entry.name, indent, index_text(medium.index(sodium_d_nm)),
                        medium.form(), range_text(medium), medium.description());
    if (!entry.aliases.empty()) text += fmt::format("{:{}} also {}\n", "", indent, alias_text(entry, ", "));
    text += fmt::format("{:{}} {}\n", "", indent, medium.source());
  }
  return text;
}

std::string media_list_csv() {
  std::string csv = "name,aliases,description,form,first_nm,last_nm,n_589,k_589,source\n";
  for (const optics::MediumEntry& entry : optics::media_library()) {
    const optics::Medium& medium = entry.medium;
    const auto range = medium.range_nm();
    const std::complex<double> index = medium.index(sodium_d_nm);
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", io::csv_cell(entry.name), io::csv_cell(alias_text(entry, " ")),
                       io::csv_cell(medium.description()), medium.form(), range ? format_number(range->first_nm) : "",
                       range ? format_number(range->last_nm) : "", format_exact(index.real()),
                       format_exact(index.imag()), io::csv_cell(medium.source()));
  }
  return csv;
}

std::string media_list_json() {
  std::string list = "[";
  for (const optics::MediumEntry& entry : optics::media_library()) {
    const optics::Medium& medium = entry.medium;
    std::string aliases;
    for (const std::string_view alias : entry.aliases) aliases += (aliases.empty() ? "" : ", ") + json_string(alias);
    JsonObject json;
    json.add("name", entry.name).add_json("aliases", "[" + aliases + "]").add("description", medium.description());
    json.add("source", medium.source()).add("form", medium.form()).add_json("range_nm", range_json(medium));
    const std::complex<double> index = medium.index(sodium_d_nm);
    json.add("n_589", index.real()).add("k_589", index.imag());
    list += (list.size() > 1 ? ",\n " : "\n ") + json.line();
  }
  return list + "\n]\n";
}

}  // namespace shabon::app
