// SPDX-License-Identifier: MIT
#pragma once

#include "lueur/image.h"
#include "lueur/view.h"
#include "shading/screen.h"

namespace lueur {

// What passes need of a view's projection for an image of this extent.
Screen screen_of_view(const View& view, Extent extent);

}  // namespace lueur
