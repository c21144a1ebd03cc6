// SPDX-License-Identifier: MIT
#include "report/folder.h"

#include <system_error>

namespace lueur::report {

Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return Error{ErrorKind::output, folder.string() + ": cannot be made a folder: " +
                                        error.message() + "; name another one"};
  return {};
}

}  // namespace lueur::report
