// A film's state as bytes: magic, version, description, state, checksum; little-endian. For one version of the program:
// another version says so.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shabon/film/flow/film_state.h"

namespace shabon::film {

std::vector<std::byte> write_checkpoint(const FlowDesc& desc, const FilmState& film);

struct Checkpoint {
  FlowDesc desc;
  FilmState film;
};
// Errors (content): anything that is not whole and unchanged.
Result<Checkpoint> read_checkpoint(std::span<const std::byte> bytes);

}  // namespace shabon::film
