// SPDX-License-Identifier: MIT
// What the program says, and where: data on stdout, everything else on stderr, one line a message.
// Text that comes from files and arguments may hold anything; control characters become "?".
#pragma once

#include <string>
#include <string_view>

#include "lueur/result.h"

namespace lueur::cli {

// The exit codes, which every --help lists.
inline constexpr int kExitDone = 0;
inline constexpr int kExitFinding = 1;        // --scan, --validate or --fail-above found something
inline constexpr int kExitDefect = 70;        // an error of our own that nothing above covers
inline constexpr int kExitInterrupted = 130;  // by SIGINT or SIGTERM; what there was is written
int exit_code(ErrorKind kind);

// "lueur: error: …" and "lueur: warning: …". The words are coloured on a terminal, unless the
// environment sets NO_COLOR.
void print_error(std::string_view message);
void print_warning(std::string_view message);

// What is under way; shown only when stderr is a terminal.
void print_progress(std::string_view message);

// Writes to stdout and flushes. Fails (ErrorKind::output) when stdout is closed, full or a pipe
// that nobody reads.
Result<void> print_data(std::string_view text);

// Makes writing safe for the rest of the process: a broken pipe becomes an error instead of a
// signal, and no file that is opened later gets the number of a standard stream that was closed.
void prepare_streams();

// `text` with each control character replaced.
std::string printable(std::string_view text);

}  // namespace lueur::cli
