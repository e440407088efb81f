// What one moment of a simulated film is written to.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/film/flow/bake.h"
#include "shabon/film/flow/flow.h"
#include "shabon/io/image.h"

namespace shabon::app {

// And what the numbers in them mean.
struct MapSizes {
  int lat_long_width = 1024;                               // twice its height
  int cube_edge = 256;                                     // nodes along an edge of a face
  std::optional<std::array<double, 2>> png_range_nm = {};  // none: from the thinnest to the thickest of each frame
  double refractive_index = 1.33;                          // of the film's liquid, for glTF
};

// Where the pictures' pixels lie on the grid, found once for all frames.
class FrameMaps {
 public:
  FrameMaps(const film::FilmFlow& flow, const MapSizes& sizes);
  std::vector<float> lat_long_nm(const film::FilmFlow& flow) const { return baked(lat_long_, flow); }
  std::vector<float> cube_nm(const film::FilmFlow& flow) const { return baked(cube_, flow); }
  const MapSizes& sizes() const { return sizes_; }

 private:
  static std::vector<float> baked(const film::FlowBake& bake, const film::FilmFlow& flow);
  MapSizes sizes_;
  film::FlowBake lat_long_, cube_;
};

struct FrameFile {
  std::string name;  // "cube.0012.exr"
  std::string bytes;
};

// The name of a file of a frame, "cube.0012.exr" from "cube" and ".exr".
std::string frame_name(std::string_view stem, int frame, std::string_view ending);

struct FrameKind {
  std::string_view name;
  std::string_view content;
  Result<std::vector<FrameFile>> (*files)(const film::FilmFlow& flow, const FrameMaps& maps, int frame,
                                          const io::Metadata& metadata);
  bool clips = false;  // to MapSizes::png_range_nm
};

// The closed set.
std::span<const FrameKind> frame_kinds();

}  // namespace shabon::app
