// Scenes of which one knows what must arrive: films that mirror a half-lit sky or a lamp, lamps over white cards,
// Brewster's angle behind a polariser, prisms. The probe gives the spectrum and its own error.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shabon/base/units.h"
#include "shabon/color/illuminant.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/stack_expression.h"
#include "shabon/render/probe.h"
#include "shabon/scene/compile.h"

namespace shabon {
namespace {

constexpr double pi = std::numbers::pi;
const std::vector<double> wavelengths_nm = {400, 450, 500, 550, 600, 650, 700};
// What the float kernel may be off, of the light that falls on the surface.
constexpr double rounding = 2e-6;

std::string number(double x) { return std::to_string(x); }

scene::Scene scene_of(const std::string& text) {
  auto scene = scene::load_scene("shabon: 1\n" + text, "test.yaml", {}, scene::Resources{});
  if (!scene) throw std::invalid_argument(scene.errors().front().message);
  return *std::move(scene);
}

render::ProbeResult probed(const scene::Scene& scene, math::Vec3d origin, math::Vec3d towards,
                           bool through_camera = false, std::size_t samples = 1024) {
  const auto result = render::probe(scene, {origin, towards - origin, through_camera}, wavelengths_nm, {samples, 1});
  if (!result) throw std::invalid_argument(result.errors().front().message);
  return *result;
}

double lamp_radiance(const std::string& lamp, double nm) {
  return color::lamp_radiance(*color::illuminant_named(lamp))[static_cast<std::size_t>(nm - color::first_nm)];
}

double reflectance(const std::string& stack, double angle_deg, double nm, int polarisation = 0) {
  const auto powers = optics::stack_powers(*optics::parse_stack(stack), optics::incidence_from(Degrees(angle_deg)), nm);
  const optics::Powers& p = powers.powers;
  return polarisation > 0 ? p.R_p : polarisation < 0 ? p.R_s : (p.R_s + p.R_p) / 2;
}

const char* dark = "environment: {constant: {illuminant: D65, scale: 0}}\n";

// A sky that is lit on the side of the camera only: a plane film shows R of it, nothing comes through.
TEST(ClosedForms, PlaneFilmUnderAHalfLitSky) {
  for (const std::string layer : {"water 150", "water 900", "soap 400", "2.4+0.1i 80", "TiO2 50"})
    for (const double angle_deg : {0.0, 20.0, 45.0, 70.0, 85.0}) {
      const std::size_t space = layer.find(' ');
      const scene::Scene scene = scene_of(
          "environment: {constant: {illuminant: D65, scale: 0}, softboxes: [{direction: [0, 0, 1], half_angle_deg: 90, "
          "illuminant: D65, scale: 1}]}\nobjects: [{quad: {width: 100, height: 100, surface: {film: {medium: " +
          layer.substr(0, space) + ", thickness: {constant_nm: " + layer.substr(space + 1) + "}}}}}]\n");
      const double a = angle_deg * pi / 180;
      const auto result = probed(scene, {5 * std::sin(a), 0, 5 * std::cos(a)}, {0, 0, 0}, false, 16);
      for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
        const double light = lamp_radiance("D65", wavelengths_nm[i]);
        const double expected = reflectance("air | " + layer + "nm | air", angle_deg, wavelengths_nm[i]);
        EXPECT_NEAR(result.radiance[i] / light, expected, 5e-6) << layer << " " << angle_deg;
        EXPECT_EQ(result.standard_error[i], 0);
      }
    }
}

// A ray that begins inside dark glass, wherever the camera is: from the middle of a ball, to and fro along a diameter.
TEST(ClosedForms, RaysBeginInTheMediumTheyAreIn) {
  const scene::Scene scene = scene_of(
      "metres_per_unit: 0.01\nenvironment: {constant: {illuminant: D65, scale: 1}}\nobjects:\n"
      "  - sphere: {radius: 1, surface: {dielectric: {stack: \"air | 1.5+2e-6i\"}}}\n");
  const auto result = probed(scene, {0, 0, 0}, {0.3, 0.2, 1}, false, 256);
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    const double radius = std::exp(-4 * pi * 2e-6 * 0.01 / (wavelengths_nm[i] * 1e-9)), R = 0.04;
    const double expected = (1 - R) * radius / (1 - R * radius * radius) * lamp_radiance("D65", wavelengths_nm[i]);
    EXPECT_NEAR(result.radiance[i], expected, 4 * result.standard_error[i] + 1e-5 * expected) << wavelengths_nm[i];
  }
}

// Every smooth boundary, under any coating, mirrors a sphere lamp as the desk says.
TEST(ClosedForms, SphereLampInASmoothSurface) {
  struct Case {
    std::string surface, stack;
  };
  const Case cases[] = {
      {"film: {medium: water, thickness: {constant_nm: 300}}", "air | water 300nm | air"},
      {"conductor: {stack: \"air | TiO2 60nm | Ti\"}", "air | TiO2 60nm | Ti"},
      {"conductor: {stack: \"air | Ag\"}", "air | Ag"},
      {"dielectric: {stack: \"air | MgF2 99nm | 1.52\"}", "air | MgF2 99nm | 1.52"},
      {"pane: {stack: \"air | MgF2 99nm | BK7 2mm incoherent | air\"}", "air | MgF2 99nm | BK7 2mm incoherent | air"}};
  for (const Case& each : cases)
    for (const double angle_deg : {0.5, 30.0, 60.0, 80.0}) {
      const double a = angle_deg * pi / 180;
      const scene::Scene scene =
          scene_of(dark + std::string("objects:\n  - quad: {width: 100, height: 100, surface: {") + each.surface +
                   "}}\n  - sphere: {position: [" + number(-4 * std::sin(a)) + ", 0, " + number(4 * std::cos(a)) +
                   "], radius: 0.01, surface: {emitter: {illuminant: A, scale: 7}}}\n");
      const auto result = probed(scene, {3 * std::sin(a), 0, 3 * std::cos(a)}, {0, 0, 0}, false, 16);
      for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
        EXPECT_NEAR(result.radiance[i] / (7 * lamp_radiance("A", wavelengths_nm[i])),
                    reflectance(each.stack, angle_deg, wavelengths_nm[i]), 6e-6)
            << each.surface << " " << angle_deg;
    }
}

// A white card of reflectance rho a distance d below a lamp shows rho L times the lamp's form factor.
TEST(ClosedForms, LampsOverACard) {
  struct Case {
    std::string lamp;
    double form_factor;
  };
  const double d = 3, r = 0.7;
  const Case cases[] = {
      {"sphere: {position: [0, 3, 0], radius: 0.7", r * r / (d * d)},
      {"disk: {position: [0, 3, 0], rotation_deg: [90, 0, 0], radius: 0.7", r * r / (r * r + d * d)},
      {"quad: {position: [0, 3, 0], rotation_deg: [90, 0, 0], width: 1.4, height: 1.4",  // over its middle
       4 * (2 / (2 * pi)) * (r / std::hypot(r, d)) * std::atan(r / std::hypot(r, d))}};
  for (const Case& each : cases) {
    const scene::Scene scene = scene_of(dark +
                                        std::string("objects:\n  - quad: {rotation_deg: [-90, 0, 0], width: 9, "
                                                    "height: 9, surface: {diffuse: {color: 0.6}}}\n  - ") +
                                        each.lamp + ", surface: {emitter: {illuminant: A, scale: 5}}}\n");
    const auto result = probed(scene, {1, 1, 1}, {0, 0, 0}, false, 1 << 15);
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
      const double light = 0.6 * 5 * lamp_radiance("A", wavelengths_nm[i]);
      EXPECT_NEAR(result.radiance[i] / light, each.form_factor, 5 * result.standard_error[i] / light + rounding)
          << each.lamp;
      EXPECT_LT(result.standard_error[i], 0.005 * result.radiance[i]) << each.lamp;
    }
  }
}

// The error is honest for every seed, also where the even spread of the walks makes batches agree.
TEST(ClosedForms, ErrorsAreHonestForEverySeed) {
  const double d = 3, r = 0.7, expected = r * r / (r * r + d * d);
  const scene::Scene scene =
      scene_of(dark + std::string("objects:\n  - quad: {rotation_deg: [-90, 0, 0], width: 9, height: 9, "
                                  "surface: {diffuse: {color: 0.6}}}\n  - disk: {position: [0, 3, 0], "
                                  "rotation_deg: [90, 0, 0], radius: 0.7, surface: {mask: {opacity: "
                                  "1, surface: {emitter: {illuminant: A, scale: 5}}}}}\n"));
  double squares = 0;
  constexpr int seeds = 40;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double nm[] = {550};
    const auto result = render::probe(scene, {{1, 1, 1}, {-1, -1, -1}, false}, nm, {.samples = 1024, .seed = seed});
    ASSERT_TRUE(result && result->standard_error[0] > 0);
    const double light = 0.6 * 5 * lamp_radiance("A", 550);
    const double z = (result->radiance[0] / light - expected) / (result->standard_error[0] / light);
    EXPECT_LT(std::abs(z), 6) << seed;
    squares += z * z;
  }
  EXPECT_LT(std::sqrt(squares / seeds), 1.5);
}

// What fades light inside does so too where the boundary neither bends nor mirrors.
TEST(ClosedForms, AbsorptionBehindABoundaryOfEqualIndex) {
  const double k = 1e-7, depth_m = 0.5;
  const scene::Scene scene = scene_of(
      "metres_per_unit: 1\nenvironment: {constant: {illuminant: E, scale: 1}}\nobjects:\n"
      "  - quad: {position: [0, 0, 0], width: 9, height: 9, surface: {dielectric: {stack: \"air | 1+1e-7i\"}}}\n"
      "  - quad: {position: [0, 0, -0.5], rotation_deg: [0, 180, 0], width: 9, height: 9, surface: {dielectric: "
      "{stack: "
      "\"air | 1+1e-7i\"}}}\n");
  const auto result = probed(scene, {0, 0, 2}, {0, 0, 0}, false, 16);
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    EXPECT_NEAR(result.radiance[i] / lamp_radiance("E", wavelengths_nm[i]),
                std::exp(-4 * pi * k * depth_m / (wavelengths_nm[i] * 1e-9)), 1e-5);
}

// A film between lamp and card dims it by T, whether shadow rays or scattered rays find the lamp.
TEST(ClosedForms, LampThroughAFilm) {
  const std::string card =
      dark + std::string(
                 "objects:\n  - quad: {rotation_deg: [-90, 0, 0], width: 9, height: 9, surface: {diffuse: {color: "
                 "0.5}}}\n  - sphere: {position: [0, 40, 0], radius: 0.2, surface: {emitter: {illuminant: E, "
                 "scale: 1000}}}\n");
  const auto without = probed(scene_of(card), {1, 1, 1}, {0, 0, 0}, false, 4096);
  const auto with = probed(scene_of(card + "  - disk: {position: [0, 38, 0], rotation_deg: [-90, 0, 0], radius: 0.5, "
                                           "surface: {film: {medium: 2.0, thickness: {constant_nm: 120}}}}\n"),
                           {1, 1, 1}, {0, 0, 0}, false, 4096);
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    const double T = 1 - reflectance("air | 2.0 120nm | air", 0, wavelengths_nm[i]);
    // Besides, the film mirrors a little of the card back to it.
    EXPECT_NEAR(with.radiance[i] / without.radiance[i], T, 2e-3);
  }
}

// At Brewster's angle glass mirrors nothing that is polarised in the plane of incidence.
TEST(ClosedForms, BrewsterBehindAPolariser) {
  const double n = 1.5, a = std::atan(n);
  const auto seen = [&](double polarizer_deg) {
    const scene::Scene scene = scene_of(
        "environment: {constant: {illuminant: E, scale: 0}, softboxes: [{direction: [0, 1, 0], half_angle_deg: 90, "
        "illuminant: E, scale: 1}]}\ncamera: {position: [0, " +
        number(5 * std::cos(a)) + ", " + number(5 * std::sin(a)) +
        "], look_at: [0, 0, 0], polarizer_deg: " + number(polarizer_deg) +
        "}\nobjects: [{quad: {rotation_deg: [-90, 0, 0], width: 100, height: 100, surface: {dielectric: {stack: \"air "
        "| "
        "1.5\"}}}}]\n");
    return probed(scene, scene.camera.position, {0, 0, 0}, true, 16).radiance[3] / lamp_radiance("E", 550);
  };
  const double R_s = std::pow((n * n - 1) / (n * n + 1), 2);
  EXPECT_NEAR(seen(90), 0, 1e-6);           // p: up in the picture
  EXPECT_NEAR(seen(0), R_s / 2, rounding);  // s: the polariser halves unpolarised light
  EXPECT_NEAR(seen(45), R_s / 4, rounding);
}

// A ray through a prism of dispersive glass leaves by Snell's law at each wavelength: a slit of light behind it is seen
// in its own colour only.
TEST(ClosedForms, PrismPartsTheWavelengths) {
  // The apex is up; 60 degrees. Seen along -z and lit from where the wavelength of 550 nm comes out.
  const auto glass = *optics::parse_stack("air | BK7");
  const double n = glass.exit.index(550).real();
  const double in = 50 * pi / 180, inside = std::asin(std::sin(in) / n), second = 60 * pi / 180 - inside;
  const double out = std::asin(n * std::sin(second));
  // The entrance's normal leans 30 degrees from the horizontal towards the viewer; directions in the yz plane.
  const auto along = [](double angle) { return math::Vec3d{0, std::sin(angle), -std::cos(angle)}; };
  const double entrance = 30 * pi / 180;  // of the outward normal above +z, mirrored: its angle from -z is pi - ...
  // The ray meets the entrance at `in` below its normal and bends down towards the base twice.
  const double first_direction = in - entrance;  // above the horizontal
  const double last_direction = first_direction - (in + out - 60 * pi / 180);
  const math::Vec3d exit_direction = along(last_direction);
  const scene::Scene scene = scene_of(
      "metres_per_unit: 1e-6\nenvironment: {constant: {illuminant: E, scale: 0}, softboxes: [{direction: [" +
      number(exit_direction.x) + ", " + number(exit_direction.y) + ", " + number(exit_direction.z) +
      "], half_angle_deg: 0.05, illuminant: E, scale: 1}]}\nobjects:\n"
      "  - quad: {position: [0, 0, 0.288675], rotation_deg: [-30, 0, 0], width: 9, height: 1, surface: {dielectric: "
      "{stack: \"air | BK7\"}}}\n"
      "  - quad: {position: [0, 0, -0.288675], rotation_deg: [210, 0, 0], width: 9, height: 1, surface: {dielectric: "
      "{stack: \"air | BK7\"}}}\n");
  const math::Vec3d start = math::Vec3d{0, -0.05, 0.288675 + 0.05 * std::tan(entrance)} - along(first_direction) * 3.0;
  const auto result = probed(scene, start, start + along(first_direction), false, 4096);
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    const double light = lamp_radiance("E", wavelengths_nm[i]);
    if (wavelengths_nm[i] == 550)
      EXPECT_GT(result.radiance[i] / light, 0.8);
    else
      EXPECT_EQ(result.radiance[i], 0) << wavelengths_nm[i];
  }
}

}  // namespace
}  // namespace shabon
