#include "shabon/film/flow/parameters.h"

#include <cmath>
#include <string>
#include <type_traits>

#include "shabon/base/text.h"
#include "shabon/film/flow/initial.h"

namespace shabon::film {

namespace {

class Checker {
 public:
  template <class T>
  void check(const T& value, const FieldInfo& info, const std::string& key) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
      number(static_cast<double>(value), info, key);
    } else if constexpr (std::is_same_v<T, math::Vec3d>) {
      for (const double x : {value.x, value.y, value.z}) number(x, info, key);
    } else if constexpr (requires { fields(Of<T>{}); }) {
      members(value, key);
    }
  }
  template <class T>
  void check(const std::optional<T>& value, const FieldInfo&, const std::string& key) {
    if (value) members(*value, key);
  }
  void check(const std::vector<AirMotion>& list, const FieldInfo&, const std::string& key) {
    for (std::size_t i = 0; i < list.size(); ++i)
      std::visit(
          [&](const auto& air) {
            const About told = about(Of<std::decay_t<decltype(air)>>{});
            members(air, key + "[" + std::to_string(i) + "]." + std::string(told.name));
          },
          list[i]);
  }
  template <class Struct>
  void members(const Struct& object, const std::string& path) {
    const auto one = [&](const auto& field) {
      check(object.*field.member, field.info, (path.empty() ? "" : path + ".") + std::string(field.key));
    };
    std::apply([&](const auto&... field) { (one(field), ...); }, fields(Of<Struct>{}));
    rules(object, path);
  }

  Diagnostics problems;

 private:
  void add(const std::string& key, const std::string& message) {
    Diagnostic problem;
    problem.key = key;
    problem.message = message;
    problems.push_back(problem);
  }
  void number(double x, const FieldInfo& info, const std::string& key) {
    if (std::isfinite(x) && info.range.contains(x)) return;
    const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
    add(key, "expected " + format_number(info.range.low) + " to " + format_number(info.range.high) + unit + ", got " +
                 (std::isfinite(x) ? format_number(x) : "no number"));
  }
  void at_most(double x, const std::string& key, double most, const std::string& most_key) {
    if (x > most)
      add(key, "expected at most " + most_key + ", which is " + format_number(most) + ", got " + format_number(x));
  }
  void direction(const math::Vec3d& v, const std::string& key) {
    if (!(math::length(v) > 1e-12)) add(key, "expected a direction, got a vector without length");
  }

  template <class Struct>
  void rules(const Struct&, const std::string&) {}
  void rules(const AirRotation& air, const std::string& path) { direction(air.axis, path + ".axis"); }
  void rules(const AirJet& air, const std::string& path) {
    direction(air.place, path + ".place");
    direction(air.direction, path + ".direction");
  }
  void rules(const RegenerationDesc& source, const std::string& path) {
    at_most(source.from_deg, path + ".from_deg", source.to_deg, "to_deg");
  }
  void rules(const BlackFilmDesc& black, const std::string& path) {
    if (!(black.thickness_nm < black.nucleation_nm))
      add(path + ".thickness_nm", "expected less than nucleation_nm, which is " + format_number(black.nucleation_nm) +
                                      ", got " + format_number(black.thickness_nm));
  }
  void rules(const RuptureDesc& rupture, const std::string& path) {
    at_most(rupture.from_nm, path + ".from_nm", rupture.to_nm, "to_nm");
  }
  void rules(const FlowDesc& desc, const std::string&) {
    at_most(desc.step.shortest_s, "step.shortest_s", desc.step.longest_s, "step.longest_s");
    slope(desc);
  }
  void slope(const FlowDesc& desc) {
    if (!(desc.initial.slope > 0)) return;
    if (!(math::length(desc.gravity_m_s2) > 0))
      return add("initial.slope", "expected 0 where gravity_m_s2 is 0: without it no height is told");
    const double most = most_balanced_squeeze(desc.initial.slope), squeezed = squeeze(desc);
    if (desc.initial.equilibrium && !(squeezed < most))
      add("initial.equilibrium",
          "expected a film light enough for its surfactant to hold it: density g radius thickness / elasticity below " +
              format_number(most, 3) + " for this slope, got " + format_number(squeezed, 3) +
              "; raise elasticity_n_m or lower mean_thickness_nm");
  }
};

}  // namespace

Diagnostics check(const FlowDesc& desc) {
  Checker checker;
  checker.members(desc, "");
  return std::move(checker.problems);
}

}  // namespace shabon::film
