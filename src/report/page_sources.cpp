// SPDX-License-Identifier: MIT
#include "report/page_sources.h"

namespace lueur::report {
namespace {

constexpr std::string_view kDom =
#include "report/page/dom.js.inc"
    ;
constexpr std::string_view kTable =
#include "report/page/table.js.inc"
    ;
constexpr std::string_view kPlot =
#include "report/page/plot.js.inc"
    ;
constexpr std::string_view kFigures =
#include "report/page/figures.js.inc"
    ;
constexpr std::string_view kToneMap =
#include "report/page/tone_map.js.inc"
    ;
constexpr std::string_view kMagma =
#include "report/page/magma.js.inc"
    ;
constexpr std::string_view kPackedPicture =
#include "report/page/packed_picture.js.inc"
    ;
constexpr std::string_view kViewport =
#include "report/page/viewport.js.inc"
    ;
constexpr std::string_view kReadOut =
#include "report/page/read_out.js.inc"
    ;
constexpr std::string_view kViews =
#include "report/page/views.js.inc"
    ;
constexpr std::string_view kViewer =
#include "report/page/viewer.js.inc"
    ;
constexpr std::string_view kErrorMaps =
#include "report/page/error_maps.js.inc"
    ;
constexpr std::string_view kTimes =
#include "report/page/times.js.inc"
    ;
constexpr std::string_view kComparison =
#include "report/page/comparison.js.inc"
    ;
constexpr std::string_view kSheet =
#include "report/page/sheet.js.inc"
    ;

}  // namespace

const std::string_view kBaseStyle =
#include "report/page/base.css.inc"
    ;
const std::string_view kComparisonStyle =
#include "report/page/comparison.css.inc"
    ;
const std::string_view kComparisonSkeleton =
#include "report/page/comparison.html.inc"
    ;
const std::string_view kFigureSkeleton =
#include "report/page/figures.html.inc"
    ;
const std::string_view kSheetStyle =
#include "report/page/sheet.css.inc"
    ;
const std::string_view kSheetSkeleton =
#include "report/page/sheet.html.inc"
    ;

const std::array<std::string_view, 13> kComparisonScripts = {
    kDom,     kTable, kPlot,   kToneMap,   kMagma, kPackedPicture, kViewport,
    kReadOut, kViews, kViewer, kErrorMaps, kTimes, kComparison};
const std::array<std::string_view, 4> kFigureScripts = {kDom, kTable, kPlot, kFigures};
const std::array<std::string_view, 2> kSheetScripts = {kDom, kSheet};

}  // namespace lueur::report
