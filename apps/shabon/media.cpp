// shabon media: the media of the library with their ranges and sources.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "json.h"
#include "options.h"
#include "shabon/optics/media.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr double sodium_d_nm = 589.3;  // where refractive indices are usually quoted

std::string range_text(const optics::Medium& medium) {
  const auto range = medium.range_nm();
  if (!range) return "all wavelengths";
  return format_number(range->first_nm) + ".." + format_number(range->last_nm) + " nm";
}

std::string index_text(std::complex<double> index) {
  return index.imag() == 0 ? fmt::format("{:.5f}", index.real())
                           : fmt::format("{:.5f}+{:.5f}i", index.real(), index.imag());
}

std::string media_text() {
  std::string text = fmt::format("{:<12} {:<18} {:<18} {}\n", "name", "n at 589.3 nm", "range", "what and whose");
  for (const optics::MediumEntry& entry : optics::media_library()) {
    const optics::Medium& medium = entry.medium;
    text += fmt::format("{:<12} {:<18} {:<18} {}\n", entry.name, index_text(medium.index(sodium_d_nm)),
                        range_text(medium), medium.description());
    if (!medium.source().empty()) text += fmt::format("{:50} {}\n", "", medium.source());
  }
  return text;
}

std::string media_json() {
  std::string list = "[";
  for (const optics::MediumEntry& entry : optics::media_library()) {
    const optics::Medium& medium = entry.medium;
    JsonObject json;
    json.add("name", entry.name).add("description", medium.description()).add("source", medium.source());
    const auto range = medium.range_nm();
    json.add_json("range_nm", range ? json_numbers({range->first_nm, range->last_nm}) : "null");
    const std::complex<double> index = medium.index(sodium_d_nm);
    json.add("n_589", index.real()).add("k_589", index.imag());
    list += (list.size() > 1 ? ",\n " : "\n ") + json.line();
  }
  return list + "\n]\n";
}

struct Format {
  std::string_view name;
  std::string (*write)();
};

constexpr Format formats[] = {{"text", media_text}, {"json", media_json}};

}  // namespace

Action declare_media(CLI::App& app) {
  const auto format = std::make_shared<std::size_t>(0);
  add_choice(app, "--format", *format, formats, "Form of the output");
  app.footer(R"(Names ignore case. Beyond its range a formula is continued (360..830 nm), a table holds its end value.

Example:
  shabon media)");
  return [format] { return print_result(formats[*format].write()); };
}

}  // namespace shabon::app
