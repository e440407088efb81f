// What other renderers reached on the same bubble, as text: they are not part of this run.
#pragma once

namespace shabon::bench {

struct Peer {
  const char *name, *film, *million_samples_per_second, *mse, *seconds_times_mse;
};

inline constexpr const char* peers_source =
    "Other renderers, measured once, on another machine: a virtual machine with 2 cores of an AMD EPYC (AVX-512), 2\n"
    "threads, 64 samples a pixel, the same bubble, camera, surroundings (not turned) and measure of error. None of "
    "them\n"
    "computes interference by wavelength: their bubble is a grey thin dielectric, so compare them with the grey film "
    "above,\n"
    "and the products with care. POV-Ray's film of three cosines, adaptive, took 12.1 s; its error was not measured.";

inline constexpr Peer peers[] = {
    {"Mitsuba 3, LLVM spectral, multijitter", "grey", "12.1", "3.2e-3", "8.2e-3"},
    {"Mitsuba 3, scalar RGB", "grey", "", "", "9.6e-3"},
    {"Cycles", "grey", "", "", "2.1e-2"},
    {"pbrt-v4", "grey", "", "", "8.9e-2"},
};

}  // namespace shabon::bench
