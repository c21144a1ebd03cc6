// SPDX-License-Identifier: MIT
// The files of page/, embedded at build time.
#pragma once

#include <array>
#include <string_view>

namespace lueur::report {

extern const std::string_view kBaseStyle;
extern const std::string_view kComparisonStyle;
extern const std::string_view kComparisonSkeleton;
extern const std::string_view kFigureSkeleton;
extern const std::string_view kSheetStyle;
extern const std::string_view kSheetSkeleton;

// Each list is one module: what a file uses stands in one before it.
extern const std::array<std::string_view, 13> kComparisonScripts;
extern const std::array<std::string_view, 4> kFigureScripts;
extern const std::array<std::string_view, 2> kSheetScripts;

}  // namespace lueur::report
