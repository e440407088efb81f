// Objects of a scene file -> spheres of films (bubbles), and placed shapes with surfaces.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "shabon/scene/compile_surfaces.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

// Where the shape stands. Sizes are > 0.
geometry::PlacedShape placed(const SphereDesc& sphere);
geometry::PlacedShape placed(const QuadDesc& quad);
geometry::PlacedShape placed(const DiskDesc& disk);
geometry::PlacedShape placed(const CylinderDesc& cylinder);
geometry::PlacedShape placed(const TorusDesc& torus);
geometry::PlacedShape placed(const TriangleDesc& triangle);

// Whatever is wrong becomes a problem.
class ObjectsCompiler {
 public:
  ObjectsCompiler(Scene& scene, SurfaceCompiler& surfaces, Problems& problems)
      : scene_(scene), surfaces_(surfaces), problems_(problems) {}

  void add(const ObjectDesc& object, const Path& path, int index);

  // After the last object: fills Scene::spheres, and warns of objects that coincide and of media that do not meet.
  // `path` leads to the list of objects.
  void finish(const std::vector<ObjectDesc>& objects, const Path& path);

  // After finish(): the camera must not stand on an object that is no bubble.
  void check_camera(const std::vector<ObjectDesc>& objects, const Path& path, const math::Vec3d& camera);

 private:
  struct Bubble {
    Sphere sphere;
    std::vector<Film> films;  // of every object with this centre and radius, outermost first
  };

  void add_one(const BubbleDesc& bubble, const Path& path, int index);
  template <class ShapeDesc>
  void add_one(const ShapeDesc& shape, const Path& path, int index);
  void add_trembling(const BubbleDesc& bubble, Film film, const Path& path, int index);
  bool move(const BubbleDesc& bubble, Film& film, const Path& path);
  void keep(Bubble& bubble);

  Scene& scene_;
  SurfaceCompiler& surfaces_;
  Problems& problems_;
  std::vector<Bubble> bubbles_;
  std::map<std::array<double, 4>, std::size_t> bubble_at_;
};

}  // namespace shabon::scene
