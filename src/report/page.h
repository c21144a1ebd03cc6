// SPDX-License-Identifier: MIT
// One HTML file with all that it needs: style, skeleton, data, pictures, scripts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lueur::report {

struct Page {
  std::string title;
  std::string_view skeleton;                 // HTML of the body
  std::vector<std::string_view> styles;      // CSS
  std::vector<std::string_view> scripts;     // one module, in this order
  nlohmann::ordered_json data;               // for the scripts
  std::vector<std::string> packed_pictures;  // base64; the scripts find them by number
};

// The page asks for nothing outside itself, and a content security policy holds it to that.
std::string page_html(const Page& page);

}  // namespace lueur::report
