// A description of a film as keys and values, to be written beside what was made of it and compared with others.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shabon/film/flow/parameters.h"

namespace shabon::film {

// Every value by its key as a scene file has it ("air[0].jet.speed_m_s"), in the order of the lists; numbers read back
// to the same bits. What is absent (no evaporation) is "none".
std::vector<std::pair<std::string, std::string>> listed(const FlowDesc& desc);

}  // namespace shabon::film
