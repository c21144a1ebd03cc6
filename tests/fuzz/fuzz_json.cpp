// SPDX-License-Identifier: MIT
// JSON text: the parser with its caps, and reads through the cursor.
#include <array>
#include <string_view>

#include "fuzz_input.h"
#include "scene/gltf_json.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string name = "input";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto json = parse_json(text, name, 16, 4096);
  if (!json.ok()) return 0;

  // Read every member as each kind of value; what does not fit has to be refused.
  const JsonCursor top(*json, name);
  for (const auto& [key, value] : json->items()) {
    const char* at = key.c_str();
    std::array<float, 3> three{};
    (void)top.boolean(at, false);
    (void)top.number(at, 0.0f);
    (void)top.text(at, "");
    (void)top.count(at, 0, 1000);
    (void)top.numbers(at, three);
    (void)top.index(at, 10, "things");
    (void)top.indices(at, 10, "things");
    (void)top.texts(at);
    (void)top.object(at);
    const auto array = top.array(at);
    for (size_t i = 0; array.ok() && i < array->size(); ++i) (void)array->element(i);
  }
  return 0;
}
