// The machine and the build that the figures belong to.
#pragma once

#include <string>

namespace shabon::bench {

// Processor, cores, compiler and the instruction set in use, in one line.
std::string machine_line();

}  // namespace shabon::bench
