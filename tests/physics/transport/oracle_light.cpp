#include "oracle_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"

namespace shabon::oracle {

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

double lamp_at(const scene::LampDesc& lamp, double wavelength_nm) {
  const color::Illuminant* illuminant = color::find_illuminant(lamp.illuminant);
  if (!illuminant) throw std::invalid_argument("no lamp " + lamp.illuminant);
  double luminance = 0;
  for (std::size_t i = 0; i < illuminant->power.size(); ++i)
    luminance += illuminant->power[i] * color::observer_1931().y[i];
  const double place = std::min(std::max(wavelength_nm - color::first_nm, 0.0), illuminant->power.size() - 1.001);
  const auto left = static_cast<std::size_t>(place);
  const double between = place - double(left);
  const double power = illuminant->power[left] * (1 - between) + illuminant->power[left + 1] * between;
  return lamp.scale * power / luminance;
}

double length(const math::Vec3d& v) { return std::sqrt(math::dot(v, v)); }

// By the angles off the axis, sideways and upwards.
bool shines(const scene::SoftboxDesc& box, const math::Vec3d& direction) {
  const math::Vec3d axis = box.direction * (1 / length(box.direction));
  if (const auto* round = std::get_if<scene::RoundShapeDesc>(&box.shape))
    return degrees(std::atan2(length(math::cross(axis, direction)), math::dot(axis, direction))) <=
           round->half_angle_deg;
  const auto& window = std::get<scene::WindowShapeDesc>(box.shape);
  // Upright is the part of y across the axis; rolled counter-clockwise as the eye sees it, up turns to the left.
  math::Vec3d up = math::Vec3d{0, 1, 0} - axis * axis.y;
  up = up * (1 / length(up));
  const math::Vec3d left = math::cross(up, axis);
  const double roll = window.roll_deg * std::numbers::pi / 180;
  const math::Vec3d rolled_up = up * std::cos(roll) + left * std::sin(roll);
  const math::Vec3d rolled_left = left * std::cos(roll) - up * std::sin(roll);
  const double ahead = math::dot(direction, axis);
  const auto off = [&](const math::Vec3d& side) {
    return degrees(std::atan2(std::abs(math::dot(direction, side)), ahead));
  };
  return off(rolled_left) <= window.width_deg / 2 && off(rolled_up) <= window.height_deg / 2;
}

}  // namespace

double radiance(const scene::EnvironmentDesc& environment, const math::Vec3d& direction, double wavelength_nm) {
  double sum = 0;
  if (const auto* constant = std::get_if<scene::ConstantEnvironmentDesc>(&environment.base)) {
    sum = lamp_at(*constant, wavelength_nm);
  } else if (const auto* gradient = std::get_if<scene::GradientEnvironmentDesc>(&environment.base)) {
    const double share = (1 + direction.y) / 2;
    sum = lamp_at(gradient->up, wavelength_nm) * share + lamp_at(gradient->down, wavelength_nm) * (1 - share);
  } else {
    throw std::invalid_argument("pictures have no place here");
  }
  for (const scene::SoftboxDesc& box : environment.softboxes)
    if (shines(box, direction)) sum += lamp_at(box, wavelength_nm);
  return sum;
}

}  // namespace shabon::oracle
