// Lamps: relative spectral powers at 1 nm.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/color/observer.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

struct Illuminant {
  std::string name, description, source;
  // Relative power per nm at 360, 361, ... 830 nm, on any scale; as published for the CIE's lamps.
  Spectrum power{};
  // What a user should be told about the spectrum, such as where it was taken as zero; mostly empty.
  std::string note = {};
};

// All lamps of the library; D65 first. They stay where they are for the life of the program.
std::span<const Illuminant> illuminants();

// By name, ignoring case, from the library; `F11` is FL11. nullptr when unknown.
const Illuminant* find_illuminant(std::string_view name);

// What one may write for a lamp, for messages and help: "D65, A, ..., blackbody:3000K, daylight:5000K".
std::string illuminant_forms();

// A lamp as a user names it: one of the library, `blackbody:3000K` (40) or `daylight:5000K` (41); the K may be left
// out. Failure::content when there is none; the message tells the nearest name or the range of temperatures. A lamp of
// one's own, `file:lamp.csv`, is read by api/lamp_file.h.
Result<Illuminant> illuminant_named(std::string_view text);

// The path in `file:PATH` or `file:"PATH"`; nothing when the text has another form.
std::optional<std::string> illuminant_file(std::string_view text);

// A lamp from samples at rising wavelengths (> 0 nm) with powers >= 0, not all of them zero within 360..830 nm: linear
// between the samples, at whole nanometres, and zero beyond them. `note` tells where that was done. Failure::content
// without a place otherwise. A spectrum of lines that are narrower than the spacing of the samples cannot be known.
Result<Illuminant> illuminant_from_samples(std::string name, std::string source, std::span<const double> wavelengths_nm,
                                           std::span<const double> powers);

// The lamp's radiance per nm as seen directly at `scale: 1`: scaled so that the sum of L ybar at 1 nm is Y = 1.
Spectrum lamp_radiance(const Illuminant& lamp, const Observer& observer = observer_1931());

}  // namespace shabon::color
