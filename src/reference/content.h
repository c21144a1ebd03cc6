// SPDX-License-Identifier: MIT
// Names a rendering by what it depends on.
#pragma once

#include <string>

#include "reference/reference.h"

namespace lueur::reference {

// 32 hexadecimal digits of everything that decides the samples: the scene's content posed at the
// shot's time, the shot, the settings, and the version of the code. How many samples are taken is
// left out, so that more of them continue a rendering.
std::string content_key(const Scene& scene, const Shot& shot, const Settings& settings);

// The same with the number of samples and the target error: what a finished rendering depends on.
std::string finished_key(const Scene& scene, const Shot& shot, const Settings& settings);

}  // namespace lueur::reference
