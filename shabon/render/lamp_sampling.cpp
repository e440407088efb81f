#include "shabon/render/lamp_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/math/normal_to.h"
#include "shabon/render/base_brightness.h"

namespace shabon::render {

namespace {

constexpr double pi = std::numbers::pi;

// The place of `value` in a rising row of sums that begins at 0, as a number of cells.
double place_in(const double* sums, int cells, double value) {
  const double* end = sums + cells + 1;
  const double* above = std::upper_bound(sums + 1, end - 1, value);
  const double low = above[-1], high = *above;
  const auto cell = static_cast<double>(above - sums - 1);
  return cell + (high > low ? std::min((value - low) / (high - low), 1 - 1e-12) : 0.5);
}

}  // namespace

DirectionTable::DirectionTable(int width, int height, const std::vector<double>& brightness)
    : width_(width), height_(height), rows_(1, 0.0) {
  columns_.reserve(static_cast<std::size_t>(height) * static_cast<std::size_t>(width + 1));
  for (int row = 0; row < height; ++row) {
    const double solid_angle = cell_solid_angle(width, height, row);
    solid_angles_.push_back(solid_angle);
    double sum = 0;
    columns_.push_back(0);
    for (int column = 0; column < width; ++column) {
      sum += solid_angle * brightness[static_cast<std::size_t>(row * width + column)];
      columns_.push_back(sum);
    }
    rows_.push_back(rows_.back() + sum);
  }
}

math::Vec3d DirectionTable::sample(double u1, double u2) const {
  const double row = place_in(rows_.data(), height_, u1 * rows_.back());
  const auto whole = static_cast<std::size_t>(row);
  const double* sums = &columns_[whole * static_cast<std::size_t>(width_ + 1)];
  const double column = place_in(sums, width_, u2 * sums[width_]);
  // Uniform in solid angle within the row.
  const double top = std::cos(pi * static_cast<double>(whole) / height_),
               bottom = std::cos(pi * static_cast<double>(whole + 1) / height_);
  const double y = top + (row - static_cast<double>(whole)) * (bottom - top);
  const double azimuth = 2 * pi * (column / width_ - 0.5), across = std::sqrt(std::max(0.0, 1 - y * y));
  return {across * std::sin(azimuth), y, -across * std::cos(azimuth)};
}

double DirectionTable::pdf(const math::Vec3d& d) const {
  const double u = 0.5 + std::atan2(d.x, -d.z) / (2 * pi), v = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi;
  const int column = std::clamp(static_cast<int>(u * width_), 0, width_ - 1);
  const int row = std::clamp(static_cast<int>(v * height_), 0, height_ - 1);
  const double* sums = &columns_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ + 1)];
  return (sums[column + 1] - sums[column]) / (rows_.back() * solid_angles_[static_cast<std::size_t>(row)]);
}

namespace {

double luminance(const color::Spectrum& radiance) { return color::radiance_to_xyz(radiance, color::observer_1931()).y; }

double solid_angle_of(const scene::RoundSoftbox& softbox) { return 2 * pi * (1 - softbox.cos_half_angle); }

double solid_angle_of(const scene::WindowSoftbox& softbox) {
  const double a = softbox.tan_half_width, b = softbox.tan_half_height;
  return 4 * std::asin(a * b / std::sqrt((1 + a * a) * (1 + b * b)));
}

math::Vec3d sample_softbox(const scene::RoundSoftbox& softbox, double u1, double u2) {
  const double rise = u1 * (1 - softbox.cos_half_angle), cosine = 1 - rise;
  const double sine = std::sqrt(std::max(0.0, rise * (2 - rise))), phi = 2 * pi * u2;
  const math::Vec3d right = math::any_normal_to(softbox.axis), up = math::cross(softbox.axis, right);
  return math::normalize(softbox.axis * cosine + right * (sine * std::cos(phi)) + up * (sine * std::sin(phi)));
}

math::Vec3d sample_softbox(const scene::WindowSoftbox& softbox, double u1, double u2) {
  const double x = (2 * u1 - 1) * softbox.tan_half_width, y = (2 * u2 - 1) * softbox.tan_half_height;
  return math::normalize(softbox.axis + softbox.right * x + softbox.up * y);
}

double softbox_density(const scene::RoundSoftbox& softbox, const math::Vec3d& d) {
  return softbox.chord_squared(d) <= softbox.rim_chord_squared() ? 1 / solid_angle_of(softbox) : 0;
}

double softbox_density(const scene::WindowSoftbox& softbox, const math::Vec3d& d) {
  const double z = math::dot(d, softbox.axis);
  if (z <= 0 || std::abs(math::dot(d, softbox.right)) > z * softbox.tan_half_width ||
      std::abs(math::dot(d, softbox.up)) > z * softbox.tan_half_height)
    return 0;
  return 1 / (z * z * z * 4 * softbox.tan_half_width * softbox.tan_half_height);
}

}  // namespace

LampSampling::LampSampling(const scene::Scene& scene) : scene_(scene), lamp_of_object_(scene.objects.size(), -1) {
  const scene::Environment& environment = scene.environment;
  std::vector<double> channel_y;
  for (const color::Spectrum& channel : environment.channels) channel_y.push_back(luminance(channel));
  const BaseBrightness grid = base_brightness(environment, channel_y);
  if (grid.irradiance > 0) base_.emplace(grid.width, grid.height, grid.brightness);
  infinity_brightness_ = grid.irradiance;
  for (std::size_t i = 0; i < environment.softboxes.size(); ++i) {
    const auto [solid_angle, brightness] = std::visit(
        [&](const auto& softbox) {
          return std::pair{solid_angle_of(softbox),
                           softbox.scale * channel_y[static_cast<std::size_t>(softbox.channel)]};
        },
        environment.softboxes[i]);
    if (solid_angle * brightness <= 0) continue;
    softboxes_.push_back({i, solid_angle * brightness, solid_angle});
    infinity_brightness_ += solid_angle * brightness;
  }
  if (infinity_brightness_ > 0) {
    base_share_ = grid.irradiance / infinity_brightness_;
    for (Softbox& softbox : softboxes_) softbox.share /= infinity_brightness_;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto* emitter =
        std::get_if<scene::EmitterSurface>(&scene.surfaces[static_cast<std::size_t>(scene.objects[i].surface)]);
    if (emitter == nullptr) continue;
    const double brightness = emitter->scale * channel_y[static_cast<std::size_t>(emitter->channel)];
    const double area = geometry::area(scene.objects[i].shape);
    if (brightness * area <= 0) continue;
    lamp_of_object_[i] = static_cast<int>(lamps_.size());
    lamps_.push_back(
        {static_cast<int>(i), brightness * area, scene.objects[i].shape.to_world.origin, area, brightness});
  }
}

// About the light that the lamp sends to the point: what it would from afar, never more than a whole sky of it.
double LampSampling::weight(const ObjectLamp& lamp, const math::Vec3d& point) const {
  const math::Vec3d away = lamp.center - point;
  return lamp.power / (math::dot(away, away) + lamp.area / pi);
}

double LampSampling::share_of_infinity(const math::Vec3d& point, double* total) const {
  double sum = infinity_brightness_;
  for (const ObjectLamp& lamp : lamps_) sum += weight(lamp, point);
  *total = sum;
  return sum > 0 ? infinity_brightness_ / sum : 0;
}

double LampSampling::direction_density(const math::Vec3d& direction) const {
  double density = base_ ? base_share_ * base_->pdf(direction) : 0;
  for (const Softbox& softbox : softboxes_)
    density += softbox.share * std::visit([&](const auto& lamp) { return softbox_density(lamp, direction); },
                                          scene_.environment.softboxes[softbox.index]);
  return density;
}

std::optional<LampDirection> LampSampling::sample(const math::Vec3d& point, double u_lamp, double u1, double u2) const {
  double total = 0;
  const double share = share_of_infinity(point, &total);
  if (!(total > 0)) return {};
  if (u_lamp < share) {
    double u = u_lamp / share;
    LampDirection result;
    result.distance = std::numeric_limits<double>::infinity();
    if (base_ && u < base_share_) {
      result.direction = base_->sample(u1, u2);
    } else {
      u -= base_share_;
      std::size_t chosen = 0;
      while (chosen + 1 < softboxes_.size() && u >= softboxes_[chosen].share) u -= softboxes_[chosen++].share;
      if (softboxes_.empty()) return {};
      result.direction = std::visit([&](const auto& lamp) { return sample_softbox(lamp, u1, u2); },
                                    scene_.environment.softboxes[softboxes_[chosen].index]);
    }
    result.pdf = share * direction_density(result.direction);
    return result;
  }
  double left = u_lamp * total - infinity_brightness_;
  std::size_t chosen = 0;
  while (chosen + 1 < lamps_.size() && left >= weight(lamps_[chosen], point)) left -= weight(lamps_[chosen++], point);
  if (lamps_.empty()) return {};
  const ObjectLamp& lamp = lamps_[chosen];
  const auto found =
      geometry::sample_toward(scene_.objects[static_cast<std::size_t>(lamp.object)].shape, point, u1, u2);
  if (!found || !(found->pdf > 0)) return {};
  return LampDirection{found->direction, found->distance, lamp.object, found->pdf * weight(lamp, point) / total};
}

double LampSampling::pdf_infinity(const math::Vec3d& point, const math::Vec3d& direction) const {
  double total = 0;
  return share_of_infinity(point, &total) * direction_density(direction);
}

double LampSampling::pdf_object(const math::Vec3d& point, int object, const math::Vec3d& direction,
                                double distance) const {
  const int index = lamp_of_object_[static_cast<std::size_t>(object)];
  if (index < 0) return 0;
  const ObjectLamp& lamp = lamps_[static_cast<std::size_t>(index)];
  double total = 0;
  share_of_infinity(point, &total);
  // In the order of sample(): the same bits.
  return geometry::pdf_toward(scene_.objects[static_cast<std::size_t>(object)].shape, point, direction, distance) *
         weight(lamp, point) / total;
}

}  // namespace shabon::render
