#include "flow_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "json.h"
#include "shabon/film/sphere_map.h"
#include "shabon/io/mesh.h"

namespace shabon::app {

namespace {

using Files = Result<std::vector<FrameFile>>;

Files one_file(std::string name, Result<std::string> bytes) {
  if (!bytes) return bytes.errors();
  return std::vector<FrameFile>{{std::move(name), std::move(bytes).value()}};
}

Files lat_long_files(const film::FilmFlow& flow, const FrameMaps& maps, int frame, const io::Metadata& metadata) {
  const int width = maps.sizes().lat_long_width;
  return one_file(frame_name("lat-long", frame, ".exr"),
                  io::encode_exr_numbers(width, width / 2, maps.lat_long_nm(flow), io::Layout::flat, metadata));
}

Files cube_files(const film::FilmFlow& flow, const FrameMaps& maps, int frame, const io::Metadata& metadata) {
  const int edge = maps.sizes().cube_edge;
  return one_file(
      frame_name("cube", frame, ".exr"),
      io::encode_exr_numbers(edge, film::face_count * edge, maps.cube_nm(flow), io::Layout::cube, metadata));
}

// KHR_materials_iridescence: thickness = minimum + G (maximum - minimum), from the texture's green channel.
Files gltf_files(const film::FilmFlow& flow, const FrameMaps& maps, int frame, const io::Metadata& metadata) {
  const std::vector<float> nm = maps.lat_long_nm(flow);
  const auto [thinnest, thickest] = std::minmax_element(nm.begin(), nm.end());
  const auto range = maps.sizes().png_range_nm.value_or(std::array<double, 2>{*thinnest, *thickest});
  const double span = std::max(range[1] - range[0], 1e-6);
  std::vector<std::uint16_t> grey;
  grey.reserve(nm.size());
  for (const float value : nm)
    grey.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::clamp((value - range[0]) / span, 0.0, 1.0))));
  const int width = maps.sizes().lat_long_width;
  io::Metadata told = metadata;
  told.emplace_back("thickness_range_nm", fmt::format("{} {}", range[0], range[1]));
  const std::string picture = frame_name("gltf", frame, ".png");
  Files files = one_file(picture, io::encode_png16(width, width / 2, grey, told));
  if (!files) return files;
  JsonObject extension;
  extension.add("iridescenceFactor", 1).add("iridescenceIor", maps.sizes().refractive_index);
  extension.add("iridescenceThicknessMinimum", range[0]).add("iridescenceThicknessMaximum", range[1]);
  extension.add_json("iridescenceThicknessTexture", JsonObject().add("index", 0).line());
  JsonObject json;
  json.add("uri", picture).add_json("KHR_materials_iridescence", extension.line());
  files.value().push_back({frame_name("gltf", frame, ".json"), json.text()});
  return files;
}

template <class Write>
Files mesh_file(const film::FilmFlow& flow, std::string name, const Write& write) {
  std::vector<std::array<float, 3>> points;
  for (const math::Vec3d& direction : flow.directions()) {
    const math::Vec3d p = direction * flow.desc().radius_m;
    points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  std::vector<float> nm, speed, surfactant;
  for (const double thickness : flow.thickness_m()) nm.push_back(static_cast<float>(thickness * 1e9));
  for (const math::Vec3d& velocity : flow.velocity_m_s()) speed.push_back(static_cast<float>(math::length(velocity)));
  for (const double share : flow.surfactant()) surfactant.push_back(static_cast<float>(share));
  const io::Mesh mesh{
      points, flow.triangles(), {{"thickness_nm", nm}, {"speed_m_s", speed}, {"surfactant", surfactant}}};
  return one_file(std::move(name), write(mesh, fmt::format("soap film at {} s, metres", flow.time_s())));
}

Files ply_files(const film::FilmFlow& flow, const FrameMaps&, int frame, const io::Metadata&) {
  return mesh_file(flow, frame_name("film", frame, ".ply"), io::ply);
}

Files vtk_files(const film::FilmFlow& flow, const FrameMaps&, int frame, const io::Metadata&) {
  return mesh_file(flow, frame_name("film", frame, ".vtk"), io::vtk);
}

constexpr FrameKind kinds[] = {
    {"lat-long", "latitude-longitude EXR in nm", lat_long_files},
    {"cube", "cube map EXR in nm", cube_files},
    {"gltf", "16-bit PNG and its range, for glTF's iridescence", gltf_files, true},
    {"ply", "mesh with thickness, speed and surfactant, for Blender", ply_files},
    {"vtk", "the same for ParaView", vtk_files},
};

}  // namespace

FrameMaps::FrameMaps(const film::FilmFlow& flow, const MapSizes& sizes)
    : sizes_(sizes),
      lat_long_(flow, film::latitude_longitude_directions(sizes.lat_long_width, sizes.lat_long_width / 2)),
      cube_(flow, film::node_directions(sizes.cube_edge)) {}

std::vector<float> FrameMaps::baked(const film::FlowBake& bake, const film::FilmFlow& flow) {
  std::vector<float> nm(bake.size());
  bake.thickness_nm(flow, nm);
  return nm;
}

std::string frame_name(std::string_view stem, int frame, std::string_view ending) {
  return fmt::format("{}.{:04}{}", stem, frame, ending);
}

std::span<const FrameKind> frame_kinds() { return kinds; }

}  // namespace shabon::app
