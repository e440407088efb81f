#include "chart_files.h"

#include <fmt/format.h>

#include <cmath>

#include "shabon/base/text.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "svg_png.h"

namespace shabon::app {

namespace {

constexpr double drawing_px_per_inch = 96;  // of SVG and CSS

Result<std::string> png(const MadeChart& chart, ChartPixels pixels) {
  const Result<io::Rgb8Image> image = rasterise(io::chart_svg(chart.drawing), pixels.width_px(chart.drawing));
  if (!image) return image.errors();
  return io::encode_png(image->width, image->height, image->rgb, {{"Title", chart.drawing.title}}, pixels.per_inch);
}

Result<std::string> svg(const MadeChart& chart, ChartPixels) { return io::chart_svg(chart.drawing); }
Result<std::string> csv(const MadeChart& chart, ChartPixels) { return chart.csv; }

constexpr ChartFileKind kinds[] = {{"png", ".png", png}, {"svg", ".svg", svg}, {"csv", ".csv", csv}};

}  // namespace

int ChartPixels::width_px(const io::Chart& drawing) const {
  return static_cast<int>(std::lround(drawing.width_px * per_inch / drawing_px_per_inch));
}

std::span<const ChartFileKind> chart_file_kinds() { return kinds; }

Result<std::vector<ChartFile>> chart_files(const std::vector<std::string>& names) {
  std::vector<ChartFile> files;
  for (const std::string& name : names) {
    const std::filesystem::path path(name);
    const ChartFileKind* found = nullptr;
    for (const ChartFileKind& kind : kinds)
      if (same_name(path.extension().string(), kind.ending)) found = &kind;
    if (found == nullptr)
      return fail(Failure::usage,
                  fmt::format("--output: expected a file ending in .png, .svg or .csv, got '{}'", printable(name)));
    files.push_back({path, found});
  }
  return files;
}

Status write_chart(const ChartFile& file, const MadeChart& chart, ChartPixels pixels) {
  const Result<std::string> bytes = file.kind->bytes(chart, pixels);
  if (!bytes) return bytes.errors();
  return io::write_file_atomically(file.path, *bytes);
}

}  // namespace shabon::app
