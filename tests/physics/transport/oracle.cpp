#include "oracle.h"

#include <pthread.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "oracle_film.h"
#include "oracle_light.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::oracle {

namespace {

using Real = long double;
using Point = math::Vec3<Real>;
using math::Vec3d;

Vec3d to_double(const Point& p) { return {double(p.x), double(p.y), double(p.z)}; }
Point to_real(const Vec3d& p) { return {p.x, p.y, p.z}; }
Point unit(const Point& p) { return p * (1 / std::sqrt(math::dot(p, p))); }

// A Hermitian 3x3 matrix: the coherency of a field, or an analyser whose trace product with it is an intensity.
struct Matrix {
  std::array<Complex, 9> m{};

  void add(Complex factor, const Vec3d& a, const Vec3d& b) {  // factor a b^T
    const double u[] = {a.x, a.y, a.z}, v[] = {b.x, b.y, b.z};
    for (std::size_t i = 0; i < 9; ++i) m[i] += factor * u[i / 3] * v[i % 3];
  }
  Complex between(const Vec3d& a, const Vec3d& b) const {  // a^T M b
    const double u[] = {a.x, a.y, a.z}, v[] = {b.x, b.y, b.z};
    Complex sum = 0;
    for (std::size_t i = 0; i < 9; ++i) sum += m[i] * u[i / 3] * v[i % 3];
    return sum;
  }
  double trace() const { return (m[0] + m[4] + m[8]).real(); }
  void operator+=(const Matrix& other) {
    for (std::size_t i = 0; i < 9; ++i) m[i] += other.m[i];
  }
};

double trace_of_product(const Matrix& a, const Matrix& b) {
  Complex sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum += a.m[3 * i + j] * b.m[3 * j + i];
  return sum.real();
}

// The two directions of the field of a transverse wave.
struct Axes {
  Vec3d s, p;
};

Matrix unpolarised(double intensity, const Axes& axes) {
  Matrix c;
  c.add(intensity / 2, axes.s, axes.s);
  c.add(intensity / 2, axes.p, axes.p);
  return c;
}

// The light behind the film to the light in front.
Matrix forward(const CoherencyFactors& x, bool depolarises, const Matrix& c, const Axes& from, const Axes& to) {
  if (depolarises) return unpolarised(x.ss * c.trace(), to);
  Matrix result;
  result.add(x.ss * c.between(from.s, from.s), to.s, to.s);
  result.add(x.pp * c.between(from.p, from.p), to.p, to.p);
  result.add(x.sp * c.between(from.s, from.p), to.s, to.p);
  result.add(std::conj(x.sp) * c.between(from.p, from.s), to.p, to.s);
  return result;
}

// The analyser in front of the film to the one behind: trace(w forward(c)) = trace(backward(w) c).
Matrix backward(const CoherencyFactors& x, bool depolarises, const Matrix& w, const Axes& from, const Axes& to) {
  if (depolarises) return unpolarised(x.ss * w.trace(), from);
  Matrix result;
  result.add(x.ss * w.between(to.s, to.s), from.s, from.s);
  result.add(x.pp * w.between(to.p, to.p), from.p, from.p);
  result.add(x.sp * w.between(to.p, to.s), from.p, from.s);
  result.add(std::conj(x.sp) * w.between(to.s, to.p), from.s, from.p);
  return result;
}

Vec3d any_perpendicular(const Vec3d& d) {
  const Vec3d other = std::abs(d.z) < 0.6 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  return to_double(unit(to_real(math::cross(other, d))));
}

struct Bubble {
  Point center;
  Real radius;
  film::ThicknessModel thickness;
  struct LayerIndex {
    std::vector<Complex> at;  // per wavelength
    double thickness_nm;
  };
  std::vector<LayerIndex> layers;  // from the outside
  std::size_t varied = 0;          // whose thickness is `thickness`
};

double thickness_nm(const film::ThicknessModel& model, Real normal_y) {
  if (const auto* constant = std::get_if<film::ConstantThickness>(&model)) return constant->constant_nm;
  const auto& linear = std::get<film::LinearThickness>(model);
  return linear.bottom_nm + (linear.top_nm - linear.bottom_nm) * double((1 + normal_y) / 2);
}

class Tree {
 public:
  Tree(const scene::SceneDesc& scene, const std::vector<double>& wavelengths_nm, const Limits& limits, Answer& answer)
      : scene_(scene), wavelengths_nm_(wavelengths_nm), limits_(limits), answer_(answer) {
    outside_.assign(wavelengths_nm.size(), 1.0);
    for (const scene::ObjectDesc& object : scene.objects) add(std::get<scene::BubbleDesc>(object));
  }

  // Which bubbles hold the point; one on a wall goes where the direction leads.
  std::vector<bool> holders(const Point& p, const Point& direction) const {
    std::vector<bool> inside;
    for (const Bubble& bubble : bubbles_) {
      const Point m = p - bubble.center;
      const Real excess = math::dot(m, m) - bubble.radius * bubble.radius;
      inside.push_back(excess < 0 || (excess == 0 && math::dot(m, direction) < 0));
    }
    return inside;
  }

  using Field = std::vector<Matrix>;  // per wavelength

  // The light that arrives at `origin` from the backward direction `d`. `analyser` is what the eye sees of it.
  Field follow(const Point& origin, const Point& d, std::vector<bool> inside, int depth, const Field& analyser) {
    const Wall wall = next_wall(origin, d, inside);
    if (wall.bubble < 0) return surroundings(to_double(d), analyser);
    ++answer_.events;
    const auto index = static_cast<std::size_t>(wall.bubble);
    const Bubble& bubble = bubbles_[index];
    const Point point = origin + d * wall.distance;
    const Point normal = unit(point - bubble.center);
    const Real along = math::dot(d, normal);
    const Point mirrored = unit(d - normal * (2 * along));
    const Point across = math::cross(d, normal);
    const Vec3d s = math::dot(across, across) > 1e-30L ? to_double(unit(across)) : any_perpendicular(to_double(d));
    // The light travels along -d and -mirrored.
    const Axes straight{s, math::cross(-to_double(d), s)}, turned{s, math::cross(-to_double(mirrored), s)};

    const bool paper = scene_.render.interference == optics::Interference::two_beam;
    if (paper && depth >= limits_.most_two_beam_events) return dark();
    double carried = 0;
    for (const Matrix& w : analyser) carried = std::max(carried, w.trace() / 2);
    const bool cut = carried < limits_.least_carried || depth >= limits_.most_events;

    std::vector<FilmResponse> film(wavelengths_nm_.size());
    Field through(film.size()), back(film.size());
    const double d_nm = thickness_nm(bubble.thickness, normal.y);
    for (std::size_t i = 0; i < film.size(); ++i) {
      film[i] = response(bubble, inside[index], i, d_nm, double(std::min<Real>(std::abs(along), 1)));
      if (cut) film[i].transmitted = kept_straight(film[i]);
      through[i] = backward(film[i].transmitted, film[i].depolarises, analyser[i], straight, straight);
      back[i] = backward(film[i].reflected, film[i].depolarises, analyser[i], turned, straight);
    }
    std::vector<bool> crossed = inside;
    crossed[index] = !crossed[index];
    Field light = follow(point, d, std::move(crossed), depth + 1, through);
    for (std::size_t i = 0; i < film.size(); ++i)
      light[i] = forward(film[i].transmitted, film[i].depolarises, light[i], straight, straight);
    if (cut) {
      ++answer_.cut;
      return light;
    }
    const Field reflected = follow(point, mirrored, std::move(inside), depth + 1, back);
    for (std::size_t i = 0; i < film.size(); ++i)
      light[i] += forward(film[i].reflected, film[i].depolarises, reflected[i], turned, straight);
    return light;
  }

 private:
  struct Wall {
    Real distance = std::numeric_limits<Real>::infinity();
    int bubble = -1;
  };

  // At one wavelength, seen from the inside or the outside.
  FilmResponse response(const Bubble& bubble, bool from_inside, std::size_t i, double d_nm, double cos_i) const {
    const auto model = scene_.render.interference;
    if (bubble.layers.size() == 1)
      return film_response(model, outside_[i], bubble.layers[0].at[i], d_nm, cos_i, wavelengths_nm_[i]);
    std::vector<Layer> layers;
    for (std::size_t j = 0; j < bubble.layers.size(); ++j)
      layers.push_back({bubble.layers[j].at[i], j == bubble.varied ? d_nm : bubble.layers[j].thickness_nm});
    if (from_inside) std::reverse(layers.begin(), layers.end());
    return stack_response(outside_[i], layers, cos_i, wavelengths_nm_[i]);
  }

  void add(const scene::BubbleDesc& bubble) {
    Bubble result{to_real(bubble.center), bubble.radius, {}, {}, 0};
    std::vector<optics::Layer> layers;
    if (const auto* film = std::get_if<scene::MediumFilmDesc>(&bubble.film)) {
      const auto found = optics::resolve_from_library(film->medium, false);
      layers = {{found ? *found : parse(film->medium + " | 1").incidence, 0, true}};
      result.thickness = *scene::thickness_model(film->thickness);
    } else {
      const auto& film_desc = std::get<scene::StackFilmDesc>(bubble.film);
      const optics::Stack stack = parse(film_desc.stack);
      layers = stack.layers;
      result.varied = film_desc.vary ? static_cast<std::size_t>(film_desc.vary->layer - 1) : 0;
      result.thickness = film::ConstantThickness{layers.at(result.varied).thickness_nm};
      if (film_desc.vary) result.thickness = *scene::thickness_model(film_desc.vary->thickness);
      for (std::size_t i = 0; i < outside_.size(); ++i) outside_[i] = stack.incidence.index(wavelengths_nm_[i]).real();
    }
    for (const optics::Layer& layer : layers) {
      auto& added = result.layers.emplace_back();
      added.thickness_nm = layer.thickness_nm;
      for (const double nm : wavelengths_nm_) added.at.push_back(layer.medium.index(nm));
    }
    bubbles_.push_back(std::move(result));
  }

  static optics::Stack parse(const std::string& text) {
    const auto stack = optics::parse_stack(text, optics::resolve_from_library);
    if (!stack) throw std::invalid_argument(text + ": " + stack.errors().front().message);
    return *stack;
  }

  // A bubble that holds the ray must be left, one that does not may be entered: which root counts needs no distance.
  // Bubbles in the same place are nested in the order of the objects, the first one outermost.
  Wall next_wall(const Point& origin, const Point& d, const std::vector<bool>& inside) const {
    Wall nearest;
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
      const Bubble& bubble = bubbles_[k];
      const Point m = origin - bubble.center;
      const Real b = -math::dot(m, d), c = math::dot(m, m) - bubble.radius * bubble.radius;  // t^2 - 2 b t + c = 0
      Real discriminant = b * b - c;
      Real t;
      if (inside[k]) {
        t = b + std::sqrt(std::max<Real>(discriminant, 0));
      } else {
        if (b <= 0 || discriminant <= 0) continue;
        t = c / (b + std::sqrt(discriminant));
      }
      t = std::max<Real>(t, 0);
      const bool same_place = nearest.bubble >= 0 && same(bubbles_[static_cast<std::size_t>(nearest.bubble)], bubble);
      const bool leaving_both = same_place && inside[k] && inside[static_cast<std::size_t>(nearest.bubble)];
      const bool as_near = same_place && std::abs(t - nearest.distance) < 1e-9L * bubble.radius;
      if (as_near ? leaving_both : t < nearest.distance) nearest = {t, static_cast<int>(k)};
    }
    return nearest;
  }

  static bool same(const Bubble& a, const Bubble& b) { return a.center == b.center && a.radius == b.radius; }

  static CoherencyFactors kept_straight(const FilmResponse& film) {
    const double ss = film.reflected.ss + film.transmitted.ss, pp = film.reflected.pp + film.transmitted.pp;
    return {ss, pp, (ss + pp) / 2};
  }

  Field dark() const { return Field(wavelengths_nm_.size()); }

  Field surroundings(const Vec3d& d, const Field& analyser) {
    Field light = dark();
    const Vec3d s = any_perpendicular(d);
    for (std::size_t i = 0; i < light.size(); ++i) {
      light[i] = unpolarised(radiance(scene_.environment, d, wavelengths_nm_[i]), {s, math::cross(-d, s)});
      answer_.from_the_eye[i] += trace_of_product(analyser[i], light[i]);
    }
    return light;
  }

  const scene::SceneDesc& scene_;
  const std::vector<double>& wavelengths_nm_;
  const Limits& limits_;
  Answer& answer_;
  std::vector<Bubble> bubbles_;
  std::vector<double> outside_;
};

// What the eye takes: both directions of the field, or the one that the polariser passes.
Matrix eye(const scene::CameraDesc& camera, const Ray& ray, const Vec3d& d) {
  Matrix result;
  if (!ray.through_polarizer || !camera.polarizer_deg) {
    const Vec3d s = any_perpendicular(d);
    return unpolarised(2, {s, math::cross(d, s)});
  }
  const Point ahead = unit(to_real(camera.target() - camera.position));
  const Point right = unit(math::cross(ahead, to_real(camera.up)));
  const Vec3d across = to_double(unit(right - to_real(d) * math::dot(right, to_real(d))));
  const Vec3d upwards = math::cross(across, d);
  const double angle = *camera.polarizer_deg * std::numbers::pi / 180;
  const Vec3d axis = across * std::cos(angle) + upwards * std::sin(angle);
  result.add(1, axis, axis);
  return result;
}

Answer trace(const scene::SceneDesc& scene, const Ray& ray, const std::vector<double>& wavelengths_nm,
             const Limits& limits) {
  Answer answer;
  answer.from_the_eye.assign(wavelengths_nm.size(), 0.0);
  Tree tree(scene, wavelengths_nm, limits, answer);
  const Point direction = unit(to_real(ray.direction));
  const Matrix analyser = eye(scene.camera, ray, to_double(direction));
  const Tree::Field light = tree.follow(to_real(ray.origin), direction, tree.holders(to_real(ray.origin), direction), 0,
                                        Tree::Field(wavelengths_nm.size(), analyser));
  for (const Matrix& c : light) answer.radiance.push_back(trace_of_product(analyser, c));
  return answer;
}

// A chain of many thousand walls is as many calls deep.
void with_a_deep_stack(std::function<void()> work) {
  constexpr std::size_t stack_bytes = std::size_t{1} << 30;  // only what is used becomes memory
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  const auto run = [](void* task) -> void* {
    (*static_cast<std::function<void()>*>(task))();
    return nullptr;
  };
  if (pthread_attr_setstacksize(&attributes, stack_bytes) != 0 || pthread_create(&thread, &attributes, run, &work) != 0)
    throw std::runtime_error("no thread for the oracle");
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

}  // namespace

Answer arriving(const scene::SceneDesc& scene, const Ray& ray, const std::vector<double>& wavelengths_nm,
                const Limits& limits) {
  Answer answer;
  with_a_deep_stack([&] { answer = trace(scene, ray, wavelengths_nm, limits); });
  return answer;
}

}  // namespace shabon::oracle
