// SPDX-License-Identifier: MIT
#include "console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/file.h"

namespace lueur::cli {
namespace {

// One write a line, so that lines of several programs do not mix. Nobody is left to tell when
// stderr itself fails.
void print_line(std::string_view word, std::string_view color, std::string_view message) {
  const char* no_color = std::getenv("NO_COLOR");
  const bool colored = ::isatty(STDERR_FILENO) && !(no_color && *no_color);
  std::string line = "lueur: ";
  if (colored) line += color;
  line += word;
  if (colored) line += "\033[0m";
  line += " " + printable(message) + "\n";
  write_all(STDERR_FILENO, line);
}

}  // namespace

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return 2;
    case ErrorKind::input:
      return 3;
    case ErrorKind::output:
      return 4;
    case ErrorKind::device:
      return 5;
    case ErrorKind::memory:
      return 6;
  }
  return kExitDefect;
}

void print_error(std::string_view message) {
  print_line("error:", "\033[1;31m", message);
}
void print_warning(std::string_view message) {
  print_line("warning:", "\033[1;33m", message);
}

void print_progress(std::string_view message) {
  if (::isatty(STDERR_FILENO)) write_all(STDERR_FILENO, printable(message) + "\n");
}

Result<void> print_data(std::string_view text) {
  if (const int error = write_all(STDOUT_FILENO, text); error != 0)
    return Error{ErrorKind::output, std::string("stdout: cannot be written: ") +
                                        std::strerror(error) + "; redirect it to a file"};
  return {};
}

void prepare_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // Opened read-only, a closed stdout still refuses what is written to it. The lowest free number
    // is this one, as the loop counts up.
    const int flags = descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", flags) == -1) return;
  }
}

std::string printable(std::string_view text) {
  std::string clean(text);
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return clean;
}

}  // namespace lueur::cli
