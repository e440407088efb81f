// A problem and the place it was found at. Rooms return diagnostics; only the applications print them.
#pragma once

#include <string>
#include <vector>

namespace shabon {

enum class Severity { warning, error };

// What kind of failure an error is; the command line turns it into its exit code.
enum class Failure {
  usage = 2,     // a flag or its range
  content = 3,   // an expression, scene, n-k file, picture or medium that cannot be understood
  file = 4,      // something that cannot be opened, read or written
  internal = 5,  // a defect of the program
};

struct Diagnostic {
  Severity severity = Severity::error;
  Failure failure = Failure::content;
  std::string source;   // file name as the user gave it, "<stack>" for an expression, or empty
  int line = 0;         // counted from 1; 0 when the place is unknown
  int column = 0;       // counted from 1, in characters; 0 when the place is unknown
  std::string key;      // dotted path such as objects[0].bubble.radius, or empty
  std::string message;  // "expected ..., got ..."
  std::string excerpt;  // the text of the line the caret points into, or empty
};

// "scene.yaml:12:18: error: objects[0].bubble.radius: expected > 0, got -1" and, where the line is known, the line
// with a caret below the column. No trailing newline.
std::string to_text(const Diagnostic& diagnostic);

// All of them, one below the other, each ending in a newline.
std::string to_text(const std::vector<Diagnostic>& diagnostics);

}  // namespace shabon
