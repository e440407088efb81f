// What the benchmarks found: tables for people (Markdown, lined up) and a flat list of figures for programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::bench {

// Repeated measurements of one quantity. The median stands for it, least and most show the noise.
struct Spread {
  double median = 0, least = 0, most = 0;
  int count = 0;
};

// `values` is not empty.
Spread spread_of(std::vector<double> values);

// "12.3 (11.9..14.0)", with so many digits after the point.
std::string shown(const Spread& spread, int digits);

// "reached" or "missed", with the goal in words.
std::string verdict(bool reached, std::string_view goal);

class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string markdown() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

class Report {
 public:
  // Text goes to standard output as it comes.
  void heading(std::string_view text);
  void paragraph(std::string_view text);
  void table(const Table& table);

  // One figure for the JSON file: "optics", "airy constant powers", "ns per event and lane".
  void record(std::string_view section, std::string_view name, std::string_view unit, const Spread& value);

  const std::string& markdown() const { return text_; }

  // A list of objects with section, name, unit, median, min, max, repetitions.
  std::string json() const;

 private:
  void print(const std::string& text);
  std::string text_;
  std::vector<std::string> figures_;
};

// Replaces what stands between the lines `<!-- bench: begin -->` and `<!-- bench: end -->` of a file.
Status update_page(const std::string& path, std::string_view text);

}  // namespace shabon::bench
