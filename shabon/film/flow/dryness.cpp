#include "shabon/film/flow/dryness.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/film/flow/exchange.h"

namespace shabon::film {

namespace {

constexpr double least_excess = 1.01;  // over the least thickness, for what counts as such
constexpr double black_excess = 1.1;   // over black film's thickness, for a film that is nearly all of it
constexpr double bare_share = 0.5;     // of the area

double dry_mean_nm(const FlowDesc& desc) {
  return std::max(common_black_film_nm, desc.black_film ? black_excess * desc.black_film->thickness_nm : 0);
}

bool evaporates(const FlowDesc& desc) { return desc.evaporation && desc.evaporation->rate_nm_s > 0; }

std::string rate_text(const FlowDesc& desc) {
  const double rate = desc.evaporation->rate_nm_s, mean = desc.mean_thickness_nm;
  return "it evaporates at " + format_number(rate, 3) + " nm/s: " + format_number(mean / rate, 3) + " s for " +
         format_number(mean, 4) + " nm";
}

std::string advice(const FlowDesc& desc) {
  const std::string slower = evaporates(desc)    ? "lower evaporation.rate_nm_s, "
                             : desc.regeneration ? "lower regeneration.rate_per_s, "
                                                 : "";
  return "; end the run earlier, " + slower + "or give rupture, so that it breaks";
}

std::string dry_text(double mean_nm) {
  return "thinner than " + format_number(mean_nm, 3) + " nm on the mean, as black film is, and all but black";
}

double share_as_thin_as_any(const FilmFlow& flow) {
  const auto thickness = flow.thickness_m();
  const auto areas = flow.areas_m2();
  double thin = 0, all = 0;
  for (std::size_t c = 0; c < thickness.size(); ++c) {
    all += areas[c];
    if (thickness[c] < least_excess * thinnest_film_m) thin += areas[c];
  }
  return thin / all;
}

}  // namespace

std::optional<std::string> why_dry_before(const FlowDesc& desc, double until_s) {
  if (!evaporates(desc) || desc.rupture) return {};
  const double dry_nm = dry_mean_nm(desc);
  const double dry_s = std::max(0.0, desc.mean_thickness_nm - dry_nm) / desc.evaporation->rate_nm_s;
  if (!(dry_s < until_s)) return {};
  return "the film dries before the end at " + format_number(until_s, 4) + " s: " + rate_text(desc) + "; from about " +
         format_number(dry_s, 3) + " s on it is " + dry_text(dry_nm) + advice(desc);
}

std::optional<std::string> why_dry(const FilmFlow& flow) {
  if (flow.rupture()) return {};
  const FlowDesc& desc = flow.desc();
  const double mean_nm = flow.report().mean_nm, dry_nm = dry_mean_nm(desc);
  const double thin = desc.black_film ? 0 : share_as_thin_as_any(flow);
  if (!(mean_nm < dry_nm) && !(thin >= bare_share)) return {};
  const std::string how = mean_nm < dry_nm ? dry_text(dry_nm)
                                           : format_number(100 * thin, 3) + " % of it is as thin as a film gets (" +
                                                 format_number(thinnest_film_m * 1e9) + " nm) and black";
  return "the film is dry at " + format_number(flow.time_s(), 4) + " s: " + how +
         (evaporates(desc) ? "; " + rate_text(desc) : "") + advice(desc);
}

}  // namespace shabon::film
