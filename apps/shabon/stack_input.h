// What spectrum and color share: the stack expression and how much interference is computed.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>

#include "shabon/base/result.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/stack.h"

namespace shabon::app {

struct StackInput {
  std::string expression;
  std::size_t interference_index = 0;
  bool reversed = false;  // the light comes from the other side

  optics::Interference interference() const { return optics::interference_models[interference_index].value; }
};

void add_stack_input(CLI::App& app, StackInput& input);

// The stack as the light meets it, when it can be computed. Files are found from the working folder.
Result<optics::Stack> read_stack(const StackInput& input);

// What to say about outer media that absorb: light that comes through one, whose powers do not add up, and, where
// `transmitted` light is shown, light that enters one.
Diagnostics power_notes(const optics::Stack& stack, bool transmitted);

inline constexpr const char* stack_help =
    R"(STACK: media and layers from the side the light comes from, separated by '|'.
The first and last medium have no thickness; a layer is a medium and a thickness (nm, um, mm, cm).
A medium is a name ('shabon media' lists them), an index such as 1.33 or 2.4+0.01i, or file:PATH (n and k).
A layer may be 'incoherent' (too thick to interfere); '( ... )^10' repeats a group.
)";

}  // namespace shabon::app
