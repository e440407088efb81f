// What a scene file says, as plain data with defaults. Members bear the names of the file's keys; units and ranges
// stand in schema_fields.h. A description can also be written in code: compile() checks it by the same lists.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shabon/io/yaml.h"
#include "shabon/math/vec.h"
#include "shabon/optics/interference.h"
#include "shabon/scene/bubble_desc.h"
#include "shabon/scene/camera_desc.h"
#include "shabon/scene/lamp_desc.h"
#include "shabon/scene/shape_desc.h"

namespace shabon::scene {

struct RenderDesc {
  int samples = 64;
  optics::Interference interference = optics::Interference::airy;
  std::uint64_t seed = 1;
  double split_threshold = 1e-3;
  int max_depth = 64;
  std::string transport = "tree";
};

struct ConstantEnvironmentDesc : LampDesc {};

struct GradientEnvironmentDesc {
  LampDesc up, down;  // mixed by (1 + y)/2
};

struct ImageEnvironmentDesc {
  std::string file;  // relative to the scene file
  double rotation_deg = 0;
  double scale = 1;
};

// A clear sky with its sun; the defaults are those of SkyConditions.
struct SkyEnvironmentDesc {
  double sun_elevation_deg = 40, sun_azimuth_deg = 0;
  double turbidity = 3;
  double scale = 1;
  bool sun = true;
  double ground_albedo = 0.2;
};

struct RoundShapeDesc {
  double half_angle_deg = 10;
};

struct WindowShapeDesc {
  double width_deg = 30, height_deg = 30;
  double roll_deg = 0;
};

struct SoftboxDesc : LampDesc {
  math::Vec3d direction{0, 1, 0};  // towards the lamp, of any length
  std::variant<RoundShapeDesc, WindowShapeDesc> shape;
};

struct EnvironmentDesc {
  std::variant<ConstantEnvironmentDesc, GradientEnvironmentDesc, ImageEnvironmentDesc, SkyEnvironmentDesc> base;
  std::vector<SoftboxDesc> softboxes;
};

// The closed set of objects.
using ObjectDesc = std::variant<BubbleDesc, SphereDesc, QuadDesc, DiskDesc, CylinderDesc, TorusDesc, TriangleDesc>;

inline constexpr int scene_file_version = 1;

struct SceneDesc {
  int shabon = scene_file_version;
  double metres_per_unit = 1;
  double time_s = 0;
  ImageDesc image;
  CameraDesc camera;
  RenderDesc render;
  EnvironmentDesc environment;
  std::vector<ObjectDesc> objects;

  // The file it was read from, so that later problems can point into it; null for a description written in code.
  std::shared_ptr<const io::YamlDocument> origin;
};

}  // namespace shabon::scene
