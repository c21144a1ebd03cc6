// SPDX-License-Identifier: MIT
#include "json_output.h"

#include <charconv>
#include <cmath>

#include "console.h"

namespace lueur::cli {

Result<void> print_json(const Json& json) {
  return print_data(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json device_json(const gpu::DeviceEntry& device) {
  return {{"index", device.index},        {"name", device.name},
          {"kind", device.kind},          {"driver", device.driver},
          {"vulkan", device.api_version}, {"memory_bytes", device.memory_bytes},
          {"missing", device.missing}};
}

Json size_json(Extent size) {
  return Json::array({size.width, size.height});
}

Json environment_json(const EnvironmentChoice& environment) {
  if (environment.file.empty()) return nullptr;
  return {{"file", environment.file},
          {"rotation_deg", as_printed(glm::degrees(environment.rotation_rad))},
          {"intensity", as_printed(environment.intensity)}};
}

Json setting_value(const SettingInfo& row, const void* settings) {
  const double value = row.get(settings);
  switch (row.kind) {
    case SettingKind::integer:
      return static_cast<int64_t>(std::llround(value));
    case SettingKind::real:
      return as_printed(static_cast<float>(value));
    case SettingKind::choice:
      return row.choices[static_cast<size_t>(value)];
    case SettingKind::toggle:
      return value != 0.0;
  }
  return nullptr;
}

Json settings_json(const TechniqueInfo* info, Technique* technique) {
  Json json = Json::object();
  if (!info) return json;
  for (const SettingInfo& row : info->settings)
    json[std::string(row.name)] = setting_value(row, technique->settings());
  return json;
}

double as_printed(float value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof(text), value);
  double printed = static_cast<double>(value);
  if (error == std::errc()) std::from_chars(text, end, printed);
  return printed;
}

double rounded_ms(double ms) {
  return std::round(ms * 1e6) / 1e6;
}

Json passes_json(const std::vector<PassTime>& passes) {
  Json list = Json::array();
  for (const PassTime& pass : passes)
    list.push_back({{"name", pass.name}, {"gpu_ms", rounded_ms(pass.gpu_ms)}});
  return list;
}

}  // namespace lueur::cli
