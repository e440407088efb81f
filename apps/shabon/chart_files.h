// The files of a chart: their kinds by their endings, and how each is written.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chart.h"
#include "shabon/base/result.h"

namespace shabon::app {

// Pixels of a PNG: so many to an inch of the drawing.
struct ChartPixels {
  double per_inch = 240;
  int width_px(const io::Chart& drawing) const;
};

struct ChartFileKind {
  std::string_view name;    // "png"
  std::string_view ending;  // ".png"
  Result<std::string> (*bytes)(const MadeChart&, ChartPixels);
};

// The closed set; PNG first.
std::span<const ChartFileKind> chart_file_kinds();

struct ChartFile {
  std::filesystem::path path;
  const ChartFileKind* kind = nullptr;
};

// Errors of Failure::usage: an ending that is no kind of chart file.
Result<std::vector<ChartFile>> chart_files(const std::vector<std::string>& names);

// Errors as io::write_file_atomically.
Status write_chart(const ChartFile& file, const MadeChart& chart, ChartPixels pixels);

}  // namespace shabon::app
