// From colours to thicknesses: what was put in comes out, as surely as it is said.
#include <gtest/gtest.h>

#include <algorithm>

#include "shabon/desk/film_color.h"
#include "shabon/desk/sweep.h"
#include "shabon/desk/thickness_color.h"
#include "shabon/desk/thickness_scan.h"
#include "thickness_films.h"

namespace shabon::desk {
namespace {

struct View {
  double angle_deg = 0;
  Side side = Side::reflected;
};

// A question that the film of this thickness would raise.
ColorQuery query_for(std::string_view expression, double thickness_nm, std::vector<View> views = {{}},
                     const char* lamp = "D65", double high_nm = 1500) {
  ColorQuery query{unknown_film(expression, high_nm), {}, *color::find_illuminant(lamp)};
  const double thickness[] = {thickness_nm};
  const optics::Stack stack = known_stack(query.film, thickness);
  for (const View& view : views) {
    const optics::Incidence incidence = optics::incidence_from(Degrees(view.angle_deg));
    const color::Spectrum share = unpolarised(stack, optics::Interference::airy, incidence, view.side);
    query.seen.push_back({color::reflectance_to_xyz(share, query.lamp), incidence, view.side});
  }
  return query;
}

ColorAnswer answer_to(const ColorQuery& query) {
  const Result<ColorAnswer> answer = thickness_from_color(query);
  EXPECT_TRUE(answer.ok()) << to_text(answer.errors());
  return answer ? *answer : ColorAnswer{};
}

double nearest(const ColorAnswer& answer, double thickness_nm) {
  double least = 1e9;
  for (const ColorCandidate& candidate : answer.candidates)
    least = std::min(least, std::abs(candidate.thickness_nm - thickness_nm));
  return least;
}

struct Film {
  const char* expression;
  std::vector<double> thicknesses_nm;
};

const Film films[] = {
    {"air | water ? | air", {0, 3.5, 30, 117.3, 250, 412.3, 700, 1500}},
    {"air | SiO2 ? | Si", {0, 55, 103.7, 300, 811}},
    {"air | 1.47 ? | water", {90, 333.3, 620}},
    {"air | TiO2 0..400nm | Ti", {25, 88, 160.5, 333}},
    {"air | Al2O3 ? | Al", {310, 500}},
    {"air | MgF2 50..250nm | glass", {99.6, 180}},
    {"air | Ag 30nm | SiO2 50..400nm | Ag 30nm | glass", {120, 233}},
    {"air | (ZnS 58nm | MgF2 50..200nm)^3 | glass", {99}},
    {"air | MgF2 100..180nm | glass 1mm incoherent | air", {140}},
};

TEST(ThicknessFromColor, GivesBackWhatWasPutIn) {
  for (const Film& film : films)
    for (const double thickness_nm : film.thicknesses_nm)
      for (const auto& [lamp, view] : {std::pair{"D65", View{0, Side::reflected}},
                                       {"A", View{50, Side::reflected}},
                                       {"F11", View{30, Side::transmitted}}}) {
        const std::string what = std::string(film.expression) + " " + std::to_string(thickness_nm) + " " + lamp;
        const ColorAnswer answer = answer_to(query_for(film.expression, thickness_nm, {view}, lamp));
        ASSERT_FALSE(answer.candidates.empty()) << what;
        const ColorCandidate& best = answer.candidates.front();
        EXPECT_TRUE(answer.found) << what;
        EXPECT_LT(best.difference, 1e-5) << what;
        // Black at both ends of nothing: a metal's colour may return to the digit, a film's never.
        EXPECT_LT(nearest(answer, thickness_nm), 1e-4) << what;
      }
}

TEST(ThicknessFromColor, TellsTheColourOfWhatItFinds) {
  const ColorQuery query = query_for("air | SiO2 ? | Si", 250, {{0, Side::reflected}, {60, Side::reflected}});
  for (const ColorCandidate& candidate : answer_to(query).candidates) {
    const double thickness[] = {candidate.thickness_nm};
    const optics::Stack stack = known_stack(query.film, thickness);
    double squares = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const color::Spectrum share =
          unpolarised(stack, optics::Interference::airy, query.seen[i].incidence, Side::reflected);
      const Color seen = color_of(share, query.lamp);
      const color::Xyz white = color::white_point(query.lamp);
      const double difference = color::ciede2000(seen.lab, color::xyz_to_lab(query.seen[i].xyz, white));
      EXPECT_NEAR(candidate.xyz[i].y, seen.xyz.y, 1e-12);
      EXPECT_NEAR(candidate.differences[i], difference, 1e-6);
      squares += difference * difference;
    }
    EXPECT_NEAR(candidate.difference, std::sqrt(squares / 2), 1e-6);
    EXPECT_NEAR(candidate.order.value_or(0), 2 * 1.4599 * candidate.thickness_nm / 550,
                1e-3 * candidate.order.value_or(0));
  }
}

// No minimum is missed and none is invented: against a plain search at a hundredth of the step.
TEST(ThicknessFromColor, FindsEveryMinimum) {
  // CIEDE2000 jumps where two hues become opposite; that is no minimum, and lies far from the colour.
  constexpr double far = 8;
  for (const Film& film : {films[0], films[1], films[3], films[6]}) {
    const ColorQuery query = query_for(film.expression, film.thicknesses_nm[1] + 0.123, {{40, Side::reflected}});
    const ColorAnswer answer = answer_to(query);
    const Unknown& unknown = query.film.unknowns.front();
    Sweep sweep{query.film.stack, unknown.layers.front(), {}, query.seen[0].incidence};
    for (double nm = unknown.low_nm; nm <= unknown.high_nm; nm += 0.05) sweep.thicknesses_nm.push_back(nm);
    const auto colors = swept_colors(sweep, query.lamp);
    ASSERT_TRUE(colors.ok());
    const color::Xyz white = color::white_point(query.lamp);
    std::vector<double> differences;
    for (const color::Xyz& xyz : *colors)
      differences.push_back(
          color::ciede2000(color::xyz_to_lab(xyz, white), color::xyz_to_lab(query.seen[0].xyz, white)));
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < differences.size(); ++i) {
      if (!(differences[i] < differences[i - 1] && differences[i] <= differences[i + 1])) continue;
      if (differences[i] > far) continue;
      ++count;
      EXPECT_LT(nearest(answer, sweep.thicknesses_nm[i]), 0.06) << film.expression << " " << sweep.thicknesses_nm[i];
    }
    const auto inside =
        std::count_if(answer.candidates.begin(), answer.candidates.end(),
                      [](const ColorCandidate& candidate) { return !candidate.at_end && candidate.difference <= far; });
    EXPECT_EQ(static_cast<std::size_t>(inside), count) << film.expression;
  }
}

TEST(ThicknessFromColor, SaysWhenSeveralOrdersLookAlike) {
  // The third and fourth orders of a soap film return to the same pinks and greens; one colour cannot tell them apart
  // under an uncertainty as large as their difference.
  ColorQuery query = query_for("air | water ? | air", 1100, {{}}, "D65", 2000);
  query.uncertainty = 3;
  const ColorAnswer answer = answer_to(query);
  EXPECT_GT(answer.in_95_percent, 1u);
  EXPECT_LT(answer.candidates.front().weight, 0.9);
  query.uncertainty = 0.02;
  EXPECT_EQ(answer_to(query).in_95_percent, 1u);
  // A second angle helps.
  ColorQuery two = query_for("air | water ? | air", 1100, {{0}, {60}}, "D65", 2000);
  two.uncertainty = 3;
  EXPECT_LT(answer_to(two).in_95_percent, answer.in_95_percent);
}

TEST(ThicknessFromColor, SaysWhenNothingFits) {
  ColorQuery query = query_for("air | water ? | air", 300);
  query.seen[0].xyz = color::linear_srgb_to_xyz({0.8, 0.1, 0.8});
  const ColorAnswer answer = answer_to(query);
  EXPECT_FALSE(answer.found);
  EXPECT_GT(answer.candidates.front().difference, answer.near);
}

TEST(ThicknessFromColor, ExposureAndMappingAreUndone) {
  ColorQuery query = query_for("air | water ? | air", 330);
  color::Xyz& xyz = query.seen[0].xyz;
  xyz = {xyz.x * 7, xyz.y * 7, xyz.z * 7};
  EXPECT_GT(answer_to(query).candidates.front().difference, 1);
  query.ignore_lightness = true;
  EXPECT_LT(nearest(answer_to(query), 330), 1e-4);
  EXPECT_NEAR(answer_to(query).candidates.front().exposure[0], 7, 1e-4);

  // A colour beyond sRGB, as a picture shows it.
  for (const color::GamutMapping mapping : {color::GamutMapping::clip, color::GamutMapping::keep_hue}) {
    ColorQuery picture = query_for("air | water ? | air", 200);
    const color::LinearRgb shown = color::xyz_to_linear_srgb(picture.seen[0].xyz);
    ASSERT_FALSE(color::in_srgb_gamut(shown));
    picture.seen[0].xyz = color::linear_srgb_to_xyz(color::map_to_srgb_gamut(shown, mapping));
    EXPECT_GT(nearest(answer_to(picture), 200), 1e-3);
    picture.seen[0].shown_by = mapping;
    EXPECT_LT(nearest(answer_to(picture), 200), 1e-3);
  }

  // A camera set to the lamp.
  ColorQuery balanced = query_for("air | SiO2 ? | Si", 200, {{}}, "A");
  const color::Xyz white = *color::white_of(color::ColorSpace::sRGB);
  balanced.seen[0].adaptation =
      color::adaptation_matrix(color::white_point(balanced.lamp), white, color::Adaptation::bradford);
  const color::Xyz raw = balanced.seen[0].xyz;
  const color::Vector3 v = color::multiply(*balanced.seen[0].adaptation, color::Vector3{raw.x, raw.y, raw.z});
  balanced.seen[0].xyz = {v[0], v[1], v[2]}, balanced.seen[0].white = white;
  EXPECT_LT(nearest(answer_to(balanced), 200), 1e-4);
}

// A colour at the distance `differences` (CIEDE2000, about normal in lightness, chroma and hue) from this one.
color::Lab disturbed(color::Lab lab, double deviation, Pcg32& random) {
  const double direction[] = {normal(random), normal(random), normal(random)};
  const double chroma = std::hypot(lab.a, lab.b), hue = std::atan2(lab.b, lab.a);
  const auto moved = [&](double by) {  // roughly in units of CIEDE2000
    const double c = chroma + by * direction[1] * (1 + 0.045 * chroma);
    const double tangent = by * direction[2] * (1 + 0.015 * chroma);
    return color::Lab{lab.L + by * direction[0], c * std::cos(hue) - tangent * std::sin(hue),
                      c * std::sin(hue) + tangent * std::cos(hue)};
  };
  const double wanted = deviation * std::hypot(direction[0], direction[1], direction[2]);
  double low = 0, high = 8 * deviation;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (color::ciede2000(moved(middle), lab) < wanted ? low : high) = middle;
  }
  return moved(low);
}

// With thicknesses drawn from the prior and colours from the noise that are assumed, stated shares are rates.
TEST(ThicknessFromColor, WeightsAndIntervalsAreAsStated) {
  Pcg32 random(11);
  double stated = 0, hits = 0, inside = 0, ambiguous = 0;
  constexpr int trials = 240;
  for (int i = 0; i < trials; ++i) {
    const double truth_nm = random.uniform(50, 900);
    ColorQuery query = query_for("air | 1.38 50..900nm | 1.5", truth_nm);
    query.uncertainty = 2;
    const color::Xyz white = color::white_point(query.lamp);
    query.seen[0].xyz =
        color::lab_to_xyz(disturbed(color::xyz_to_lab(query.seen[0].xyz, white), query.uncertainty, random), white);
    const ColorAnswer answer = answer_to(query);
    ambiguous += answer.in_95_percent > 1;
    const auto heaviest =
        std::max_element(answer.candidates.begin(), answer.candidates.end(),
                         [](const ColorCandidate& a, const ColorCandidate& b) { return a.weight < b.weight; });
    stated += heaviest->weight;
    const double half_nm = heaviest->interval_high_nm - heaviest->interval_low_nm;
    hits += truth_nm > heaviest->interval_low_nm - half_nm && truth_nm < heaviest->interval_high_nm + half_nm;
    inside += std::any_of(answer.candidates.begin(), answer.candidates.end(), [&](const ColorCandidate& candidate) {
      return truth_nm >= candidate.interval_low_nm && truth_nm <= candidate.interval_high_nm;
    });
  }
  EXPECT_GT(ambiguous, trials / 20);
  EXPECT_NEAR(hits / trials, stated / trials, 0.06);
  EXPECT_NEAR(inside / trials, credible_share, 0.035);
}

// Thick metal has one colour, and rounding makes minima of it: they are one stretch, which is told as such.
TEST(ThicknessFromColor, LevelStretchesAreOne) {
  for (const char* expression : {"air | Ag ? | glass", "air | Al ? | glass", "air | Au ? | Si"})
    for (const double uncertainty : {1, 5}) {
      ColorQuery query = query_for(expression, 200, {{}}, "D65", 500);
      query.uncertainty = uncertainty;
      const ColorAnswer answer = answer_to(query);
      const auto level = std::find_if(answer.candidates.begin(), answer.candidates.end(),
                                      [](const ColorCandidate& candidate) { return candidate.level.has_value(); });
      ASSERT_NE(level, answer.candidates.end()) << expression;
      EXPECT_LE(answer.candidates.size(), 3u) << expression;
      EXPECT_TRUE(level->opaque) << expression;
      EXPECT_GT(level->level->low_nm, 5) << expression;
      EXPECT_LT(level->level->low_nm, 120) << expression;
      EXPECT_EQ(level->level->high_nm, 500) << expression;
      EXPECT_GT(level->weight, 0.9) << expression;
    }
  // A range that ends where a seventh of the light still passes is not opaque, though hardly any returns from below.
  ColorQuery thin = query_for("air | Ag ? | glass", 30, {{}}, "D65", 32);
  thin.film.unknowns.front().low_nm = 26;
  thin.uncertainty = 5;
  const ColorAnswer seen_through = answer_to(thin);
  ASSERT_TRUE(seen_through.candidates.front().level);
  EXPECT_FALSE(seen_through.candidates.front().opaque);
  // A clear film is never opaque, and where its colour tells nothing the whole range is level.
  ColorQuery vague = query_for("air | SiO2 ? | Si", 300);
  vague.uncertainty = 1000;
  const ColorAnswer answer = answer_to(vague);
  ASSERT_TRUE(answer.candidates.front().level);
  EXPECT_FALSE(answer.candidates.front().opaque);
  vague.uncertainty = 1;
  EXPECT_FALSE(answer_to(vague).candidates.front().level);
}

// An incoherent layer has no fringes that would bound its range, and no orders; its absorption tells the thickness.
TEST(ThicknessFromColor, FindsIncoherentLayers) {
  const std::string expression = "air | 1.5+1e-5i ? incoherent | air";
  const double thickness_nm = 1.7e6;
  ColorQuery query;
  query.film = unknown_film(expression, 5e6);
  const double found_nm[] = {thickness_nm};
  const optics::Stack stack = known_stack(query.film, found_nm);
  query.seen = {
      {color::reflectance_to_xyz(unpolarised(stack, optics::Interference::airy, {}, Side::transmitted), query.lamp),
       {},
       Side::transmitted}};
  const auto answer = thickness_from_color(query);
  ASSERT_TRUE(answer.ok());
  EXPECT_TRUE(answer->found);
  EXPECT_NEAR(answer->candidates.front().thickness_nm, thickness_nm, 1);
  EXPECT_FALSE(answer->candidates.front().order.has_value());
}

// Tied layers are looked at as closely as single ones: where their fringes are finer than 1 nm their colours are means.
TEST(ThicknessFromColor, TiedLayersHaveTheColoursOfTheFilm) {
  for (const std::string expression : {"air | (1.45 ? | 1.6 100nm)^2 | glass", "air | (water ?)^2 | air"}) {
    ColorQuery query;
    query.film = unknown_film(expression, 39.6e3);
    query.film.unknowns.front().low_nm = 39.3e3;
    const double asked_nm[] = {39.4e3};
    const optics::Stack stack = known_stack(query.film, asked_nm);
    query.seen = {
        {color::reflectance_to_xyz(unpolarised(stack, optics::Interference::airy, {}, Side::reflected), query.lamp)}};
    const auto answer = thickness_from_color(query);
    ASSERT_TRUE(answer.ok()) << expression;
    const ColorCandidate& best = answer->candidates.front();
    EXPECT_LT(best.difference, 0.05) << expression;
    const double best_nm[] = {best.thickness_nm};
    const color::Xyz exact = color::reflectance_to_xyz(
        unpolarised(known_stack(query.film, best_nm), optics::Interference::airy, {}, Side::reflected), query.lamp);
    EXPECT_NEAR(best.xyz.front().y, exact.y, 2e-4) << expression;
  }
}

TEST(ThicknessFromColor, IntervalsHoldTheirThickness) {
  for (const Film& film : films)
    for (const double uncertainty : {0.5, 3.0, 20.0}) {
      ColorQuery query = query_for(film.expression, film.thicknesses_nm.front());
      query.uncertainty = uncertainty;
      double sum = 0;
      for (const ColorCandidate& candidate : answer_to(query).candidates) {
        EXPECT_LE(candidate.interval_low_nm, candidate.thickness_nm) << film.expression << " " << uncertainty;
        EXPECT_GE(candidate.interval_high_nm, candidate.thickness_nm) << film.expression << " " << uncertainty;
        EXPECT_LT(candidate.interval_low_nm, candidate.interval_high_nm) << film.expression << " " << uncertainty;
        sum += candidate.weight;
      }
      EXPECT_NEAR(sum, 1, 1e-12);
    }
}

// A misfit with many equal valleys, of which few are kept: the others keep their share.
TEST(ThicknessScan, WhatIsLeftOutStillWeighs) {
  const Misfit misfit = [](const std::vector<double>& at) {
    std::vector<double> values;
    for (const double nm : at) values.push_back(40 * (1 - std::cos(2 * std::numbers::pi * nm / 10)));
    return values;
  };
  const std::vector<ScanMinimum> minima = scanned_minima(misfit, {5, 105, 0.1}, 4);
  ASSERT_EQ(minima.size(), 4u);
  for (const ScanMinimum& minimum : minima) EXPECT_NEAR(minimum.weight, 0.1, 1e-3);
  EXPECT_EQ(count_credible({0.1, 0.1, 0.1, 0.1}), 4u);
}

// Of a lopsided valley the interval is the shortest: both its ends are as likely, or one is the end of the valley.
TEST(ThicknessScan, IntervalsAreTheShortest) {
  const Misfit steep = [](const std::vector<double>& at) {  // p = exp(-x) from 10 on, next to nothing below
    std::vector<double> values;
    for (const double nm : at) values.push_back(nm < 10 ? 400 * (10 - nm) : 2 * (nm - 10));
    return values;
  };
  const std::vector<ScanMinimum> minima = scanned_minima(steep, {0, 60, 0.1}, 10);
  ASSERT_EQ(minima.size(), 1u);
  EXPECT_NEAR(minima[0].thickness_nm, 10, 1e-6);
  EXPECT_NEAR(minima[0].interval_low_nm, 10, 0.02);
  EXPECT_NEAR(minima[0].interval_high_nm, 10 - std::log(0.05), 0.05);
  EXPECT_FALSE(minima[0].level);
}

TEST(ThicknessFromColor, RefusesWhatItCannotAnswer) {
  const auto message = [](const ColorQuery& query) {
    const auto answer = thickness_from_color(query);
    return answer ? std::string() : answer.errors().front().message;
  };
  const ColorQuery good = query_for("air | water ? | air", 300);
  EXPECT_EQ(message(good), "");
  ColorQuery bad = good;
  bad.film = unknown_film("air | water 3nm | air");
  EXPECT_NE(message(bad).find("expected a layer of unknown thickness"), std::string::npos);
  bad.film = unknown_film("air | water ? | 1.5 ? | air");
  EXPECT_NE(message(bad).find("at most 1 unknown"), std::string::npos);
  bad = good, bad.seen.clear();
  EXPECT_NE(message(bad).find("expected a colour"), std::string::npos);
  bad = good, bad.seen[0].xyz.x = NAN;
  EXPECT_NE(message(bad).find("finite"), std::string::npos);
  bad = good, bad.seen[0].xyz = {}, bad.ignore_lightness = true;
  EXPECT_NE(message(bad).find("black"), std::string::npos);
  bad = good, bad.uncertainty = 0;
  EXPECT_NE(message(bad).find("uncertainty"), std::string::npos);
  bad = good, bad.film.unknowns[0].high_nm = 1e9;
  EXPECT_NE(message(bad).find("expected a range of at most"), std::string::npos);
  bad = good, bad.film.unknowns[0].high_nm = bad.film.unknowns[0].low_nm;
  EXPECT_NE(message(bad).find("that rises"), std::string::npos);
}

}  // namespace
}  // namespace shabon::desk
