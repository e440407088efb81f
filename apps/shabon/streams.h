// Standard output carries results, standard error carries messages. Both are written here and nowhere else.
#pragma once

#include <string>
#include <string_view>

#include "shabon/base/result.h"

namespace shabon::app {

inline constexpr int success = 0;

// Call once, first. A closed pipe and a file that may not grow become errors that can be reported, and a standard
// stream that was closed by the caller stays unwritable: without this the next opened file would take its number and
// receive the results.
void guard_standard_streams();

// Writes a result to standard output. Returns the exit code: 0, or 4 with a message when not everything was written.
int print_result(std::string_view text);

// One line on standard error. Failing to write it is no failure of the command.
void say(std::string_view line);

// Prints the problems on standard error and returns the exit code of the first error, 0 when all are warnings.
int report(const Diagnostics& diagnostics);

Diagnostic warning_of(std::string message);

bool is_terminal_output();   // standard output
bool is_terminal_message();  // standard error

}  // namespace shabon::app
