#include "shabon/color/observer.h"

#include <vector>

#include "shabon/base/text.h"
#include "shabon/color/table_columns.h"

namespace shabon::color {

std::span<const Observer> observers() {
  static const std::vector<Observer> all = [] {
    std::vector<Observer> list;
    for (const Table& table : tables::observers())
      list.push_back({table.name, table.source, spectrum_column(table, 1), spectrum_column(table, 2),
                      spectrum_column(table, 3), table.description});
    return list;
  }();
  return all;
}

const Observer& observer_1931() { return observers().front(); }

const Observer* find_observer(std::string_view name) {
  for (const Observer& observer : observers())
    if (same_name(observer.name, name)) return &observer;
  return nullptr;
}

}  // namespace shabon::color
