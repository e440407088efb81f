#include "scenes.h"

#include <algorithm>
#include <stdexcept>

namespace shabon::testing_scenes {

namespace {

using film::ConstantThickness;
using film::LinearThickness;

scene::ObjectDesc stack_bubble(math::Vec3d center, double radius, std::string stack) {
  return scene::BubbleDesc{center, radius, scene::StackFilmDesc{std::move(stack)}};
}

// One layer of the stack drains.
scene::ObjectDesc stack_bubble(math::Vec3d center, double radius, std::string stack, int layer,
                               film::ThicknessModel thickness) {
  return scene::BubbleDesc{
      center, radius,
      scene::StackFilmDesc{std::move(stack), scene::VariedLayerDesc{layer, scene::thickness_desc(thickness)}}};
}

// More bubbles than are looked at one by one.
std::vector<scene::ObjectDesc> cluster() {
  std::vector<scene::ObjectDesc> result;
  for (int i = 0; i < 48; ++i)
    result.push_back(bubble({0.4 * (i % 5) - 0.8, 0.4 * (i / 5 % 5) - 0.8, 0.3 * ((i * 5) % 7) - 1.0},
                            0.16 + 0.02 * (i % 5), "water", LinearThickness{100.0 + 9 * i, 700}));
  return result;
}

std::vector<Surroundings> make_surroundings() {
  scene::EnvironmentDesc gradient, softboxes, windows;
  gradient.base = scene::GradientEnvironmentDesc{{"D65", 1}, {"A", 0.1}};
  softboxes.base = scene::ConstantEnvironmentDesc{{"D65", 0.2}};
  softboxes.softboxes = {{{"D65", 20}, {1, 1, 1}, scene::RoundShapeDesc{12}},
                         {{"A", 5}, {-1, 0.3, -2}, scene::RoundShapeDesc{100}}};
  windows.base = scene::ConstantEnvironmentDesc{{"E", 0.05}};
  windows.softboxes = {{{"D65", 10}, {-1, 1, 1}, scene::WindowShapeDesc{40, 30, 0}},
                       {{"D65", 3}, {0.4, -0.2, -1}, scene::WindowShapeDesc{120, 50, 25}},
                       {{"A", 4}, {-1, 0.8, 1}, scene::WindowShapeDesc{30, 60, -70}}};
  return {{"constant", uniform("D65", 0.2)}, {"gradient", gradient}, {"softboxes", softboxes}, {"windows", windows}};
}

}  // namespace

scene::ObjectDesc bubble(math::Vec3d center, double radius, std::string medium, film::ThicknessModel thickness) {
  return scene::BubbleDesc{center, radius, scene::MediumFilmDesc{std::move(medium), scene::thickness_desc(thickness)}};
}

const std::vector<Arrangement>& arrangements() {
  const LinearThickness draining{150, 900};
  static const std::vector<Arrangement> list = {
      {"single", {bubble({0, 0, 0}, 1, "water", draining)}},
      {"even", {bubble({0.2, -0.1, 0}, 0.9, "1.3333333333333333", ConstantThickness{380})}},
      {"no thickness", {bubble({0, 0, 0}, 1, "water", ConstantThickness{0})}},
      {"dense", {bubble({0, 0, 0}, 1, "2.4", ConstantThickness{115})}},
      {"overlapping",
       {bubble({-0.4, 0, 0}, 0.8, "water", draining), bubble({0.5, 0.2, 0.3}, 0.7, "1.4", ConstantThickness{520})}},
      {"three overlapping",
       {bubble({-0.4, 0, 0}, 0.8, "water", draining), bubble({0.5, 0.2, 0.3}, 0.7, "1.4", ConstantThickness{520}),
        bubble({0.1, 0.5, -0.4}, 0.6, "water", LinearThickness{300, 250})}},
      {"nested",
       {bubble({0, 0, 0}, 1, "water", draining), bubble({0.2, 0.3, 0.1}, 0.5, "1.5", ConstantThickness{240}),
        bubble({0.25, 0.3, 0.1}, 0.2, "water", ConstantThickness{1200})}},
      {"concentric",
       {bubble({0, 0, 0}, 1, "water", draining), bubble({0, 0, 0}, 0.999, "1.4", ConstantThickness{300}),
        bubble({0, 0, 0}, 0.5, "water", ConstantThickness{640})}},
      {"touching",
       {bubble({-0.5, 0, 0}, 0.5, "water", draining), bubble({0.5, 0, 0}, 0.5, "1.4", ConstantThickness{520}),
        bubble({-0.25, 0, 0}, 0.25, "water", ConstantThickness{430})}},
      {"coincident",
       {bubble({0, 0, 0}, 1, "water", draining), bubble({0.3, 0, 0}, 0.4, "water", ConstantThickness{300}),
        bubble({0, 0, 0}, 1, "1.5", ConstantThickness{410})}},
      {"absorbing",
       {bubble({-0.3, 0, 0}, 0.8, "1.4+0.05i", draining), bubble({0.3, 0.1, 0.2}, 0.6, "water", ConstantThickness{500}),
        bubble({-0.3, 0, 0}, 0.8, "0.2+3i", ConstantThickness{12})},
       false},
      {"air in water",
       {stack_bubble({-0.6, 0, 0}, 0.6, "water | air 260nm | water"),
        stack_bubble({0.6, 0.1, 0.2}, 0.5, "water | 1.6 350nm | water")},
       true,
       false},
      {"stacks",  // neither of them the same from both sides
       {stack_bubble({-0.5, 0, 0}, 0.6, "air | 1.8 62nm | water 300nm | 1.46 95nm | air", 2, draining),
        stack_bubble({0.6, 0.2, 0.3}, 0.45, "air | (1.7 70nm | 1.4 100nm)^3 | water 240nm | air")}},
      {"absorbing stacks",
       {stack_bubble({-0.3, 0, 0}, 0.8, "air | 1.5 120nm | 0.2+3i 9nm | water 300nm | air", 3, draining),
        stack_bubble({0.3, 0.1, 0.2}, 0.6, "air | 2.2+0.03i 140nm | water 500nm | air"),
        stack_bubble({-0.3, 0, 0}, 0.5, "air | 1.7+0.4i 25nm | 1.4 200nm | air")},
       false},
      {"gaps in glass",  // light tunnels through the air
       {stack_bubble({0, 0, 0}, 0.8, "1.5 | 2.1 90nm | air 180nm | 1.38 110nm | 1.5")},
       true,
       false},
      {"cluster", cluster()},
  };
  return list;
}

bool computable(const Arrangement& arrangement, optics::Interference model) {
  return model == optics::Interference::airy ||
         std::none_of(arrangement.bubbles.begin(), arrangement.bubbles.end(), [](const scene::ObjectDesc& object) {
           const auto* stack = std::get_if<scene::StackFilmDesc>(&std::get<scene::BubbleDesc>(object).film);
           return stack != nullptr && std::count(stack->stack.begin(), stack->stack.end(), '|') > 2;
         });
}

const Arrangement& arrangement(const std::string& name) {
  for (const Arrangement& entry : arrangements())
    if (entry.name == name) return entry;
  throw std::invalid_argument("no arrangement " + name);
}

const std::vector<Surroundings>& surroundings() {
  static const std::vector<Surroundings> list = make_surroundings();
  return list;
}

const scene::EnvironmentDesc& light(const std::string& name) {
  for (const Surroundings& entry : surroundings())
    if (entry.name == name) return entry.light;
  throw std::invalid_argument("no light " + name);
}

scene::EnvironmentDesc uniform(const std::string& illuminant, double scale) {
  scene::EnvironmentDesc result;
  result.base = scene::ConstantEnvironmentDesc{{illuminant, scale}};
  return result;
}

scene::SceneDesc scene_of(const Arrangement& arrangement, const scene::EnvironmentDesc& light) {
  scene::SceneDesc result;
  result.image = {8, 8};
  result.camera.position = {0.3, 0.4, 5};
  result.camera.vertical_fov_deg = 26;
  result.environment = light;
  result.objects = arrangement.bubbles;
  return result;
}

scene::Scene compiled(const scene::SceneDesc& description) {
  auto scene = scene::compile(description, {});
  if (!scene) throw std::invalid_argument(scene.errors().front().message);
  return *std::move(scene);
}

}  // namespace shabon::testing_scenes
