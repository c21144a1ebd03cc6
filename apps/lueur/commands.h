// SPDX-License-Identifier: MIT
// The commands of the program. Each add_…() puts one command and its options into the parser; once
// the command line is read, the chosen command runs and leaves its outcome.
#pragma once

#include "lueur/result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace lueur::cli {

// The exit code, or the error that is to be printed.
using Outcome = Result<int>;

void add_render(CLI::App& program, Outcome& outcome);
void add_reference(CLI::App& program, Outcome& outcome);
void add_compare(CLI::App& program, Outcome& outcome);
void add_paper(CLI::App& program, Outcome& outcome);
void add_sequence(CLI::App& program, Outcome& outcome);
void add_bench(CLI::App& program, Outcome& outcome);
void add_diff(CLI::App& program, Outcome& outcome);
void add_scene(CLI::App& program, Outcome& outcome);
void add_scene_sheet(CLI::App& scene, Outcome& outcome);  // a command of `lueur scene`
void add_devices(CLI::App& program, Outcome& outcome);
void add_techniques(CLI::App& program, Outcome& outcome);

// The last part of every --help.
inline constexpr char kExitCodes[] =
    "\nExit codes: 0 done, 1 a check found something (--scan, --validate, --fail-above),\n"
    "2 usage, 3 input file, 4 output file or stdout, 5 device, 6 memory, 70 a defect in lueur,\n"
    "130 interrupted.";

}  // namespace lueur::cli
