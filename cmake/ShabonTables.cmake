# Filled by the colour room: turns data/*.csv into C++ arrays at build time.
