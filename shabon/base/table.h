// A table of numbers from data/, built into the library (cmake/ShabonTables.cmake writes the values).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace shabon {

struct Table {
  std::string_view name;         // what users call it, such as "D65"
  std::string_view description;  // one line
  std::string_view unit;         // of every column
  std::string_view source;       // who published the numbers, and where
  std::string_view licence;      // of the numbers
  std::span<const std::string_view> column_names;
  std::span<const std::span<const double>> columns;  // all of one length; the first one increases
};

}  // namespace shabon
