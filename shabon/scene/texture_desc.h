// Pictures that vary something over a surface, as a scene file names them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/film/range.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/ranges.h"

namespace shabon::scene {

// How often a picture fits on the surface, to the right and downwards.
struct Repeat {
  double u = 1, v = 1;
  friend bool operator==(const Repeat&, const Repeat&) = default;
};

// low + (high - low) times the picture's value.
struct NumberMapDesc {
  std::string file;  // relative to the scene file
  double low = 0, high = 1;
  Repeat repeat;
};

// As above in nm; without low_nm and high_nm the picture's values are the nanometres. Perhaps one picture a frame.
struct ThicknessMapDesc {
  std::string file;  // relative to the scene file; #### stands for the number of the frame
  std::optional<double> low_nm, high_nm;
  std::string layout = "surface";
  Repeat repeat;
  std::optional<int> first_frame, last_frame;
  std::optional<double> frames_per_second;
};

// A picture of reflectances: encoded sRGB in whole numbers (PNG, JPEG), linear sRGB in floating ones.
struct ColorMapDesc {
  std::string file;  // relative to the scene file
  Repeat repeat;
};

inline constexpr FieldInfo repeat_info{.range = repeat_range,
                                       .doc = "how often it fits on the surface, to the right and downwards"};

constexpr std::string_view section(Of<NumberMapDesc>) { return "map of numbers"; }
constexpr auto fields(Of<NumberMapDesc>) {
  return std::tuple{
      Field{"file",
            &NumberMapDesc::file,
            {.required = true,
             .doc = "PNG, JPEG, OpenEXR or HDR picture, relative to the scene file; of colours the mean"}},
      Field{"low", &NumberMapDesc::low, {.range = share_range, .doc = "the number where the picture is 0 (black)"}},
      Field{"high", &NumberMapDesc::high, {.range = share_range, .doc = "the number where the picture is 1 (white)"}},
      Field{"repeat", &NumberMapDesc::repeat, repeat_info}};
}

constexpr About about(Of<ThicknessMapDesc>) { return {.name = "map", .doc = "A picture, or one for each frame."}; }

std::vector<std::string_view> map_layouts();

constexpr auto fields(Of<ThicknessMapDesc>) {
  constexpr FieldInfo low{.unit = "nm",
                          .range = film::thickness_range_nm,
                          .doc = "thickness where the picture is 0; without it the picture holds nanometres"};
  constexpr FieldInfo high{
      .unit = "nm", .range = film::thickness_range_nm, .doc = "thickness where the picture is 1; beside low_nm"};
  constexpr FieldInfo frame{.range = frame_range, .unset = "0", .doc = "number of the frame shown at time 0"};
  constexpr FieldInfo last_frame{
      .range = frame_range, .unset = "no end", .doc = "number of the last frame, which stays ever after"};
  return std::tuple{
      Field{
          "file",
          &ThicknessMapDesc::file,
          {.required = true,
           .doc =
               "PNG, JPEG, OpenEXR or HDR picture, relative to the scene file; of colours the mean; \"film.####.exr\": "
               "one for each frame, between two of them their mixture"}},
      Field{"low_nm", &ThicknessMapDesc::low_nm, low},
      Field{"high_nm", &ThicknessMapDesc::high_nm, high},
      Field{"layout",
            &ThicknessMapDesc::layout,
            {.names = map_layouts,
             .doc = "`surface`: laid over the surface by its (u, v), latitude and longitude on a bubble; `cube`: six "
                    "faces below each other, seen from the middle"}},
      Field{"repeat", &ThicknessMapDesc::repeat, repeat_info},
      Field{"first_frame", &ThicknessMapDesc::first_frame, frame},
      Field{"last_frame", &ThicknessMapDesc::last_frame, last_frame},
      Field{"frames_per_second",
            &ThicknessMapDesc::frames_per_second,
            {.range = frame_rate_range, .unset = "24", .doc = "frames in each second of the scene's time"}}};
}

constexpr std::string_view section(Of<ColorMapDesc>) { return "map of colours"; }
constexpr auto fields(Of<ColorMapDesc>) {
  return std::tuple{
      Field{"file",
            &ColorMapDesc::file,
            {.required = true,
             .doc = "PNG or JPEG (encoded sRGB), OpenEXR or HDR picture (linear sRGB), relative to the scene file"}},
      Field{"repeat", &ColorMapDesc::repeat, repeat_info}};
}

void check(const NumberMapDesc& map, const Path& path, Problems& problems);
void check(const ThicknessMapDesc& map, const Path& path, Problems& problems);
void check(const ColorMapDesc& map, const Path& path, Problems& problems);

}  // namespace shabon::scene
