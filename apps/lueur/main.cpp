// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <sstream>

#include "arguments.h"
#include "commands.h"
#include "console.h"

namespace lueur::cli {
namespace {

constexpr char kFooter[] =
    "Examples:\n"
    "  lueur render cornell -o cornell.png\n"
    "  lueur render room.glb --technique none -o direct.png\n"
    "  lueur render atrium --set samples=32 --json -o atrium.exr\n"
    "  lueur diff atrium.png reference.png\n"
    "  lueur bench --scene atrium --size 1280x720\n"
    "  lueur scene list\n"
    "\nData goes to stdout, messages to stderr. NO_COLOR turns colours off.";

int report(const Error& error) {
  print_error(error.message);
  return exit_code(error.kind);
}

// What is wrong with the command line, and whose --help tells more.
std::string describe(const CLI::App& program, const CLI::ParseError& mistake) {
  std::string name = "lueur";
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  std::string text = mistake.what();
  if (const auto commands = command->get_subcommands({}); !commands.empty()) {
    const std::vector<std::string> unknown = command->remaining();
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const CLI::App* known : commands) names.push_back(known->get_name());
    const bool is_option = !unknown.empty() && unknown.front().starts_with('-');
    text = unknown.empty()
               ? "a command is missing"
               : "'" + unknown.front() + "': no such " + (is_option ? "option here" : "command");
    text += "; the commands are " + joined(names);
  }
  return text + "; see " + name + " --help";
}

int run(int argc, char** argv) {
  CLI::App program("Lueur adds indirect light to pictures of 3D scenes, in real time.", "lueur");
  program.set_version_flag("--version", std::string("lueur ") + LUEUR_VERSION,
                           "Print the version and exit");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.get_formatter()->column_width(30);
  program.require_subcommand(1);
  program.footer(std::string(kFooter) + "\n" + kExitCodes);

  Outcome outcome = kExitDone;
  add_render(program, outcome);
  add_reference(program, outcome);
  add_compare(program, outcome);
  add_sequence(program, outcome);
  add_bench(program, outcome);
  add_paper(program, outcome);
  add_diff(program, outcome);
  add_scene(program, outcome);
  add_devices(program, outcome);
  add_techniques(program, outcome);

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help or --version
    std::ostringstream text;
    program.exit(wish, text, text);
    const auto printed = print_data(text.str());
    return printed.ok() ? kExitDone : report(printed.error());
  } catch (const CLI::ParseError& mistake) {
    return report({ErrorKind::usage, describe(program, mistake)});
  }
  return outcome.ok() ? *outcome : report(outcome.error());
}

}  // namespace
}  // namespace lueur::cli

int main(int argc, char** argv) {
  lueur::cli::prepare_streams();
  try {
    return lueur::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    lueur::cli::print_error("memory: not enough for this scene and size; choose a smaller one");
    return lueur::cli::exit_code(lueur::ErrorKind::memory);
  } catch (const std::exception& exception) {
    lueur::cli::print_error(std::string("unexpected: ") + exception.what() +
                            "; please report this");
    return lueur::cli::kExitDefect;
  }
}
