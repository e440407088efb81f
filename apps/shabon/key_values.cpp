#include "key_values.h"

#include <fmt/format.h>

#include <map>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_characters = 400;

// As it stands in the table.
std::string stored(const std::string& text) { return printable(trim(text), most_characters); }

bool same_value(const std::string& a, const std::string& b) {
  if (stored(a) == stored(b)) return true;
  const auto x = parse_number(trim(a)), y = parse_number(trim(b));
  return x && y && *x == *y;
}

using ByKey = std::map<std::string, std::string>;

ByKey by_key(const KeyValues& values) {
  ByKey sorted;
  for (const auto& [key, value] : values) sorted.emplace(stored(key), value);
  return sorted;
}

const std::string* find(const ByKey& values, const std::string& key) {
  const auto found = values.find(stored(key));
  return found == values.end() ? nullptr : &found->second;
}

}  // namespace

Status write_key_values(const std::filesystem::path& path, const KeyValues& values) {
  std::string text = "key,value\n";
  for (const auto& [key, value] : values) text += io::csv_cell(stored(key)) + "," + io::csv_cell(stored(value)) + "\n";
  return io::write_file_atomically(path, text);
}

Result<KeyValues> read_key_values(const std::filesystem::path& path) {
  const auto table = io::read_csv(path);
  if (!table) return table.errors();
  const auto key = table->column("key"), value = table->column("value");
  if (!key || !value) {
    Diagnostics errors = fail(Failure::content, "expected the columns 'key' and 'value'");
    errors.front().source = path.string();
    return errors;
  }
  KeyValues values;
  for (const io::CsvRow& row : table->rows) values.emplace_back(row.cells[*key].text, row.cells[*value].text);
  return values;
}

std::optional<std::string> first_difference(const KeyValues& a, const std::string& a_place, const KeyValues& b,
                                            const std::string& b_place) {
  const auto told = [&](const std::string& key, const std::string* there, const std::string* here) {
    const auto text = [](const std::string* value) { return value ? printable(*value, 60) : "not given"; };
    return fmt::format("{}: {} in {}, {} in {}", printable(key, 120), text(there), a_place, text(here), b_place);
  };
  const ByKey in_a = by_key(a), in_b = by_key(b);
  for (const auto& [key, value] : a)
    if (const std::string* other = find(in_b, key); other == nullptr || !same_value(value, *other))
      return told(key, &value, other);
  for (const auto& [key, value] : b)
    if (find(in_a, key) == nullptr) return told(key, nullptr, &value);
  return {};
}

}  // namespace shabon::app
