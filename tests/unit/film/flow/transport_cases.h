// Flows on the sphere whose end is known, moving a tracer with a uniform carrier.
#pragma once

#include <functional>
#include <vector>

#include "shabon/film/flow/metric.h"
#include "shabon/film/flow/transport.h"

namespace shabon::film::test {

// Stream function of the unit sphere, (73), at a time of 0..1.
using Stream = std::function<double(const math::Vec3d&, double)>;
using Profile = std::function<double(const math::Vec3d&)>;

struct Carried {
  double relative_l2 = 0;      // of the difference from the start, over the start
  double mass_drift = 0;       // relative
  double least = 0, most = 0;  // of all steps
  double courant = 0;
  int steps = 0;
};

// One turn of the time, in as many steps as keep below the Courant number.
Carried carry(int level, const Stream& stream, const Profile& profile, double courant);

// Once around `axis`.
Stream rotation_about(const math::Vec3d& axis);
// The deforming flow without divergence of Nair and Lauritzen (2010), case 4: it comes back after the turn.
double deforming(const math::Vec3d& at, double time);

// A cosine bell of height 1 and radius r around a direction.
double bell(const math::Vec3d& at, const math::Vec3d& centre, double r);

}  // namespace shabon::film::test
