// SPDX-License-Identifier: MIT
// lueur devices: what Vulkan offers, and whether it will do.
#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>

#include "arguments.h"
#include "base/try.h"
#include "commands.h"
#include "console.h"
#include "json_output.h"

namespace lueur::cli {
namespace {

Outcome run(bool as_json) {
  LUEUR_TRY(devices, gpu::System::list_devices());
  if (as_json) {
    Json list = Json::array();
    for (const gpu::DeviceEntry& device : devices) list.push_back(device_json(device));
    LUEUR_TRY_VOID(print_json({{"devices", list}}));
    return kExitDone;
  }
  std::ostringstream out;
  for (const gpu::DeviceEntry& device : devices) {
    out << device.index << "  " << printable(device.name) << " (" << device.kind << "), Vulkan "
        << device.api_version << ", " << printable(device.driver) << ", "
        << (device.memory_bytes >> 20) << " MiB";
    if (!device.missing.empty()) out << "; cannot be used, lacks " << joined(device.missing);
    out << "\n";
  }
  if (devices.empty()) print_warning("no Vulkan device; install a driver (mesa-vulkan-drivers)");
  LUEUR_TRY_VOID(print_data(out.str()));
  return kExitDone;
}

}  // namespace

void add_devices(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("devices", "List the devices that Vulkan offers");
  auto as_json = std::make_shared<bool>(false);
  command->add_flag("--json", *as_json, "One JSON object on stdout");
  command->footer(std::string("Examples:\n"
                              "  lueur devices\n"
                              "  lueur render cornell --device 1 -o cornell.png\n"
                              "  lueur render cornell --device llvmpipe -o cornell.png\n") +
                  kExitCodes);
  command->callback([as_json, &outcome] { outcome = run(*as_json); });
}

}  // namespace lueur::cli
