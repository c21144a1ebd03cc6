// SPDX-License-Identifier: MIT
// A series: the same technique at several values of one thing, and the law that its time follows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "candidate.h"
#include "statistics.h"
#include "timing.h"

namespace lueur::cli {

struct Scale {
  std::string flag;  // the one that asked for it, for errors
  std::string of;    // "pixels", "triangles", or a technique's setting that is a number
  std::vector<std::string> values;
};

// `text` is "of" or "of=value,value…". Sizes in pixels are WIDTHxHEIGHT; by default they are shares
// of `size`, so that the picture keeps its shape. There are defaults for pixels, triangles, samples
// and levels. Fails (ErrorKind::usage) where there is none, and on a value given twice.
Result<Scale> parse_scale(const std::string& flag, const std::string& text, Extent size);

// `base` at one of the values. Fails (ErrorKind::usage) on a value that cannot be, on triangles
// with another scene than `atrium`, and on a technique that has no such setting.
Result<CandidateRequest> at_value(const Scale& scale, const std::string& value,
                                  const CandidateRequest& base);

// Time as a function of the value: of the technique, of all passes, or of a group of passes. The
// times are medians_in_turn() of the values at which there is any.
struct ScaleFit {
  std::string group;
  double first_ms = 0;  // at the first and the last of these
  double last_ms = 0;
  std::optional<PowerLaw> power;
  std::optional<Line> line;
};

struct Series {
  std::string technique;       // label
  size_t first = 0;            // index of its first candidate
  std::vector<double> x;       // by value: pixels, triangles drawn, or the setting
  std::vector<ScaleFit> fits;  // of what takes time at two values or more
};

// `techniques` are labels; the candidates are those of the first at each value of `scale`, then
// those of the second, and so on.
std::vector<Series> fit_series(const Scale& scale, std::span<const std::string> techniques,
                               std::span<const Candidate> candidates, const Rounds& rounds);

}  // namespace lueur::cli
