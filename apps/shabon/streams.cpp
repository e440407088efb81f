#include "streams.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace shabon::app {

namespace {

// 0, or the errno of the write that failed.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

void guard_standard_streams() {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1) continue;
    // The lowest free number is the one just found closed. Read only: a write to it keeps failing.
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) return;
  }
}

int print_result(std::string_view text) {
  const int error = write_all(STDOUT_FILENO, text);
  if (error == 0) return success;
  return report(fail(Failure::file, "cannot write to standard output: " + std::generic_category().message(error)));
}

void say(std::string_view line) { write_all(STDERR_FILENO, std::string(line) + "\n"); }

int report(const Diagnostics& diagnostics) {
  write_all(STDERR_FILENO, to_text(diagnostics));
  for (const Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == Severity::error) return static_cast<int>(diagnostic.failure);
  return success;
}

Diagnostic warning_of(std::string message) {
  Diagnostic warning;
  warning.severity = Severity::warning;
  warning.message = std::move(message);
  return warning;
}

bool is_terminal_output() { return ::isatty(STDOUT_FILENO) == 1; }
bool is_terminal_message() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace shabon::app
