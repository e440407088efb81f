// Films to begin with, by name.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shabon/film/flow/parameters.h"

namespace shabon::film {

struct FlowPreset {
  std::string_view name;
  std::string_view doc;  // one line
  FlowDesc desc;
};

// fresh, drain, gust, old, giant, glycerol, huang2020, linear1989.
const std::vector<FlowPreset>& flow_presets();

// The preset of a name, ignoring case, or nothing.
const FlowPreset* flow_preset(std::string_view name);

}  // namespace shabon::film
