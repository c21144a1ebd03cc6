// SPDX-License-Identifier: MIT
// Where a page and its tables go.
#pragma once

#include <filesystem>

#include "lueur/result.h"

namespace lueur::report {

// Makes the folder and those above it where they are missing. Fails with ErrorKind::output.
Result<void> make_folder(const std::filesystem::path& folder);

}  // namespace lueur::report
