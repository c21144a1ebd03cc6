// SPDX-License-Identifier: MIT
// What every --json output is made of. Keys keep the order in which they were put in.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "environment_choice.h"
#include "gpu/system.h"
#include "lueur/context.h"
#include "lueur/result.h"
#include "lueur/technique.h"

namespace lueur::cli {

using Json = nlohmann::ordered_json;

// One object on stdout. Text that is not UTF-8 is shown with replacement characters.
Result<void> print_json(const Json& json);

Json device_json(const gpu::DeviceEntry& device);
Json size_json(Extent size);  // [width, height]
// File, turn in degrees and factor; null where none was chosen.
Json environment_json(const EnvironmentChoice& environment);

// A setting as JSON's own kind: number, text for a choice, true or false.
Json setting_value(const SettingInfo& row, const void* settings);
// All settings of a technique by name; {} for nullptr.
Json settings_json(const TechniqueInfo* info, Technique* technique);

// A number as short as a float has digits, and a time without digits that no clock has.
double as_printed(float value);
double rounded_ms(double ms);

Json passes_json(const std::vector<PassTime>& passes);

}  // namespace lueur::cli
