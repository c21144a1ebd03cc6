// SPDX-License-Identifier: MIT
// Text that may hold anything, made safe for the place where it goes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace lueur::report {

// The text with U+FFFD in place of bytes that are not UTF-8.
std::string valid_utf8(std::string_view text);

// For text between tags and within quoted attributes of HTML; valid UTF-8.
std::string html_escaped(std::string_view text);

// Indented, ends with a line end; text in it is valid UTF-8.
std::string json_file(const nlohmann::ordered_json& json);

// Compact JSON that may stand within a <script> element, as it holds no '<' at all.
std::string json_for_script(const nlohmann::ordered_json& json);

// RFC 4648, with padding.
std::string base64(std::span<const uint8_t> bytes);

}  // namespace lueur::report
