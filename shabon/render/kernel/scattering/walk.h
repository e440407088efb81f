// Follows one ray of the camera through a scene with surfaces: (26), (27), and where light scatters, light from lamps
// and scattered rays share what both can find, (58).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shabon/render/kernel/scattering/lobe.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// How a walk begins.
struct WalkStart {
  math::Vec3d origin, direction;
  FramedRow row;
  float carried = 1;         // mean of row.q0
  std::uint32_t sample = 0;  // number in the pixel's sequence
  std::uint32_t seed = 0;    // of the pixel
  std::size_t comb = 0;
  std::optional<int> space;  // the medium around the origin, ScatteringTables::spaces; by default the camera's
};

struct WalkCounts {
  std::uint64_t rays = 0, shadow_rays = 0, events = 0, cut_paths = 0, dropped = 0;
};

// What came back.
struct WalkLight {
  Lanes radiance{0.0f};
  Lanes alone{0.0f};  // of paths of which only the hero's wavelength is left
  // Light at infinity that was met before any surface: per channel, it has the same colour in every comb.
  bool direct = false;
  float direct_carried = 0;
};

class Walk {
 public:
  explicit Walk(const ScatteringTables& tables);

  // `direct_coefficients` get the environment's coefficients when the result is direct.
  WalkLight follow(const WalkStart& start, std::vector<double>& direct_coefficients);

  const WalkCounts& counts() const { return counts_; }

 private:
  struct Ray {
    math::Vec3d origin, direction;
    FramedRow row;
    float carried = 1;
    int from = geometry::no_shape;
    int space = 0;
    std::int16_t film_slot = -1;
    std::int16_t depth = 0;
    std::uint32_t key = 0;   // names the branch for the random numbers
    bool one_lane = false;   // only the hero's wavelength is left
    bool by_chance = false;  // some direction so far was chosen at random
    // Since the last surface that scattered the ray ran straight: lamps were sampled from there as well.
    bool shares_lamps = false;
    math::Vec3d scattered_at;
    double density = 0;  // of the direction chosen there
  };

  void step(Ray& ray);
  void leave(const Ray& ray);
  void add(const Lanes& q0, const Lanes& radiance, double weight, bool alone);
  void estimate(const Ray& ray, const Vertex& vertex);
  template <class IsDrawn>
  void draw_one(const IsDrawn& is_drawn, double u01);
  void choose(const Ray& ray);
  void meet(const Ray& ray, const Vertex& vertex, int shape);
  void light_from_lamps(const Ray& ray, const Vertex& vertex, const LocalFrame& frame, int shape);
  bool reach_lamp(const Vertex& vertex, int start, const LampDirection& lamp, int space, Lanes& radiance);
  void go_smooth(const Ray& ray, const Vertex& vertex, const Lobe& lobe, int shape, std::uint32_t key);
  void go_rough(const Ray& ray, const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, int shape,
                std::uint32_t key);
  void push(Ray& ray, std::uint32_t key, float least);
  float threshold() const;
  bool outlives_depth(Ray& ray, const Vertex& vertex, int shape);
  void pass_cut(const Ray& ray, const Vertex& vertex, int shape, Block block);
  int space_behind(const Lobe& lobe, const Vertex& vertex, int otherwise) const;
  Lanes environment(const math::Vec3d& direction);
  void fade(Row& row, int space, double distance) const;

  // A surface on the way to a lamp that lets light through straight.
  struct Crossing {
    math::Vec3d s;
    Block block;
  };

  const ScatteringTables& tables_;
  WalkCounts counts_;
  std::vector<Ray> rays_;
  std::vector<Crossing> crossings_;
  std::vector<double> coefficients_;
  bool single_path_ = false;
  Lobes lobes_, lobes_on_the_way_;
  WalkLight light_;
  std::uint32_t sample_ = 0;
  std::size_t comb_ = 0;
  int hero_ = 0;
  std::uint64_t events_before_ = 0;  // this walk
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
