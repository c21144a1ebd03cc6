// SPDX-License-Identifier: MIT
// URIs of a glTF file: data carried in them, or files beside the asset. Nothing outside the asset's
// folder is ever opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"

namespace lueur {

// The bytes of "data:<media type>;base64,<text>". Fails on other encodings and malformed base64.
// The messages of these functions do not name the place; the caller does.
Result<std::vector<uint8_t>> decode_data_uri(std::string_view uri);

// The file a relative, percent-encoded URI means. Fails on schemes, absolute paths and anything
// that leads out of `folder`, symbolic links included.
Result<std::filesystem::path> confined_path(const std::filesystem::path& folder,
                                            std::string_view uri);

// The same for a plain file name, as OBJ and MTL files have them: not percent-encoded, and with
// slashes of either kind.
Result<std::filesystem::path> confined_file(const std::filesystem::path& folder, std::string name);

bool is_data_uri(std::string_view uri);

// The media type of a data URI, empty where it gives none. None if what stands before the comma is
// not "data:<type>;<name>=<value>...;base64", all parts of which may be left out.
std::optional<std::string_view> media_type(std::string_view data_uri);

}  // namespace lueur
