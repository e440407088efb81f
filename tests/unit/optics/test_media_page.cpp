// docs/media.md holds the library and the formulas as they are.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "shabon/base/text.h"
#include "shabon/optics/media.h"

namespace shabon::optics {
namespace {

std::string between_marks(const std::string& name) {
  std::ostringstream page;
  page << std::ifstream(SHABON_SOURCE_DIR "/docs/media.md").rdbuf();
  const std::string text = page.str(), begin = "<!-- " + name + " -->\n", end = "<!-- end of " + name + " -->";
  const std::size_t first = text.find(begin), last = text.find(end);
  if (first == std::string::npos || last == std::string::npos) return "no marks of " + name;
  return text.substr(first + begin.size(), last - first - begin.size());
}

std::string index_text(std::complex<double> index) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4f", index.real());
  return index.imag() == 0 ? text : text + (" + " + format_number(index.imag(), 3)) + "i";
}

std::string library_table() {
  std::string table = "| name | index | by | range (nm) | what | source |\n|---|---|---|---|---|---|\n";
  for (const MediumEntry& entry : media_library()) {
    std::string names = "`" + std::string(entry.name) + "`";
    for (const std::string_view alias : entry.aliases) names += " `" + std::string(alias) + "`";
    const auto range = entry.medium.range_nm();
    table += "| " + names + " | " + index_text(entry.medium.index(589.3)) + " | " + std::string(entry.medium.form()) +
             " | " + (range ? format_number(range->first_nm, 6) + ".." + format_number(range->last_nm, 6) : "all") +
             " | " + entry.medium.description() + " | " + entry.medium.source() + " |\n";
  }
  return table;
}

std::string formula_table() {
  std::string table = "| formula | name | equation | takes |\n|---|---|---|---|\n";
  for (const DispersionFormulaEntry& entry : dispersion_formulas)
    table += "| " + std::to_string(entry.number) + " | " + std::string(entry.name) + " | `" +
             std::string(entry.equation) + "` | " + std::string(entry.counts) + " |\n";
  return table;
}

// The failure shows the table to put between the marks.
TEST(MediaPage, HoldsTheLibrary) { EXPECT_EQ(between_marks("the library"), library_table()); }
TEST(MediaPage, HoldsTheFormulas) { EXPECT_EQ(between_marks("the formulas"), formula_table()); }

}  // namespace
}  // namespace shabon::optics
