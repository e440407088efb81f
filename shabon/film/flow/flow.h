// The simulated soap film of a bubble: thickness, surfactant and velocity on the sphere, advanced in time
// (docs/living-film.md). One thread; several films may run on several threads.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shabon/base/progress.h"
#include "shabon/base/result.h"
#include "shabon/film/flow/parameters.h"
#include "shabon/film/flow/report.h"
#include "shabon/math/vec.h"

namespace shabon::film {

class FilmFlow {
 public:
  // Thickness in nm in a unit direction from the centre. It is scaled to the mean thickness of the description.
  using InitialThickness = std::function<double(const math::Vec3d& from_centre)>;

  // Errors: what check(desc) tells; an initial thickness that is not positive somewhere.
  static Result<FilmFlow> start(const FlowDesc& desc, const InitialThickness& initial = {});

  // Continues where checkpoint() was taken, with the same bits. Errors (content): bytes that are damaged, cut off or of
  // another version. The description is part of the bytes.
  static Result<FilmFlow> resume(std::span<const std::byte> checkpoint);

  FilmFlow(FilmFlow&&) noexcept;
  FilmFlow& operator=(FilmFlow&&) noexcept;
  ~FilmFlow();

  // Steps until the time is exactly `time_s` (earlier times: nothing), until `stop` is set, or until the film breaks.
  // Errors (content): steps would be shorter than the shortest, or the solver does not converge. The flow then keeps
  // its last good state, and the text says what to change.
  Status advance_to(double time_s, const StopFlag* stop = nullptr);

  double time_s() const;
  const FlowDesc& desc() const;
  // The state now. What counts steps, iterations and extremes of speed speaks of the time since the last call of
  // begin_report() (a frame), what is in ledgers of the time since the start.
  FlowReport report() const;
  void begin_report();
  // Where and when the film broke.
  struct Rupture {
    double time_s = 0;
    double threshold_nm = 0;
    math::Vec3d from_centre;
  };
  std::optional<Rupture> rupture() const;

  std::vector<std::byte> checkpoint() const;

  // The grid: unit directions of the cells, and triangles of three cells each, counterclockwise seen from outside.
  std::span<const math::Vec3d> directions() const;
  std::span<const std::array<int, 3>> triangles() const;
  std::span<const double> areas_m2() const;
  // One value a cell.
  std::span<const double> thickness_m() const;
  std::span<const double> surfactant() const;  // relative to its mean
  std::vector<math::Vec3d> velocity_m_s() const;

 private:
  struct State;
  explicit FilmFlow(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace shabon::film
