// What a PNG must have before anything is allocated for it. Inside the room only.
#pragma once

#include <cstdint>
#include <string_view>

namespace shabon::io {

// Each byte of deflated data makes at most 1032 (RFC 1951's longest match over its shortest code), and a pixel has at
// least one bit: a short file that claims more is refused, and so is one without its last chunk.
inline bool png_is_whole(std::string_view bytes, std::uint64_t pixels) {
  constexpr std::string_view end_chunk("IEND\xAE\x42\x60\x82", 8);
  return pixels / 8 <= bytes.size() * std::uint64_t{1032} && bytes.find(end_chunk) != std::string_view::npos;
}

}  // namespace shabon::io
