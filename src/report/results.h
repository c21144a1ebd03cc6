// SPDX-License-Identifier: MIT
// The numbers of a comparison as files for other programs.
#pragma once

#include <string>

#include "report/comparison.h"

namespace lueur::report {

// Everything but the pictures, keys in a fixed order. A value that is not finite is null.
Json results_json(const Comparison& comparison);

// RFC 4180 with '\n' as line end and one line of headings: label, technique, reference,
// technique_ms, frame_ms, then the metrics by name. An entry that was held against no reference has
// one row with an empty reference. A value that is missing or not finite is an empty cell.
std::string results_csv(const Comparison& comparison);

}  // namespace lueur::report
