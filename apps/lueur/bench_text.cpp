// SPDX-License-Identifier: MIT
#include <cstdio>

#include "bench_report.h"
#include "console.h"

namespace lueur::cli {
namespace {

constexpr size_t kNameColumns = 32;
constexpr double kBytesPerMiB = 1024.0 * 1024.0;

// Formatted numbers, which are never long.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

// The first column of a row; a long name takes a line of its own.
std::string name_cell(const std::string& name) {
  std::string cell = "  " + printable(name);
  if (cell.size() > kNameColumns) cell += "\n";
  return cell.ends_with('\n') ? cell + std::string(kNameColumns, ' ')
                              : cell + std::string(kNameColumns - cell.size(), ' ');
}

std::string or_dash(const char* pattern, int columns, const std::optional<double>& value) {
  return value ? format(pattern, *value) : format("%*s", columns, "-");
}

std::string spread_cells(const Distribution& ms) {
  return format("%10.3f%10.3f%10.3f%10.3f", ms.median, ms.least, ms.lower_quartile,
                ms.upper_quartile);
}

std::string size_text(Extent size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

// One candidate: all of its passes.
std::string run_text(const Candidate& candidate, const Summary& summary) {
  std::string text = name_cell("pass") + format("%10s%10s%10s%10s%10s%15s\n", "gpu ms", "least",
                                                "lower q.", "upper q.", "cpu ms", "cpu ns/sample");
  for (const PassSummary& pass : summary.passes) {
    text += name_cell(pass.name) + spread_cells(pass.gpu_ms) + format("%10.3f", pass.cpu_ms);
    if (pass.samples)
      text += format("%15.3f", pass.cpu_ms * 1e6 / static_cast<double>(*pass.samples));
    text += "\n";
  }
  text += name_cell("technique") + spread_cells(summary.technique_ms) +
          format("%10.3f\n", summary.technique_cpu_ms);
  if (summary.host_ms.most > 0.0)
    text += name_cell("host, for the technique") + spread_cells(summary.host_ms) + "\n";
  text += name_cell("all passes") + spread_cells(summary.frame_ms) + "\n";
  text += name_cell("frame, wall and process") + spread_cells(summary.wall_ms) +
          format("%10.3f\n", summary.cpu_ms.median);
  text += format("  memory: technique %.1f MiB, scene and renderer with it %.1f MiB\n",
                 static_cast<double>(candidate.memory.technique) / kBytesPerMiB,
                 static_cast<double>(candidate.memory.total) / kBytesPerMiB);
  return text;
}

// A row each for `count` candidates, by what `name` calls them.
template <class Name>
std::string comparison_text(const BenchReport& report, size_t first, size_t count,
                            const std::string& title, Name name) {
  std::string text = name_cell(title) + format("%10s%9s%9s%8s%10s%8s%10s\n", "technique", "least",
                                               "cpu ms", "ratio", "frame", "ratio", "own MiB");
  for (size_t i = first; i < first + count; ++i) {
    const Summary& summary = report.summaries[i];
    text += name_cell(name(i)) +
            format("%10.3f%9.3f%9.3f", summary.technique_ms.median, summary.technique_ms.least,
                   summary.technique_cpu_ms) +
            or_dash("%8.3f", 8, summary.technique_ratio) +
            format("%10.3f", summary.frame_ms.median) + or_dash("%8.3f", 8, summary.frame_ratio) +
            format("%10.1f\n",
                   static_cast<double>(report.candidates[i].memory.technique) / kBytesPerMiB);
  }
  return text;
}

std::string series_text(const BenchReport& report, const Series& series) {
  const std::vector<std::string>& values = report.scale->values;
  std::string text = printable(series.technique) + ":\n";
  text += comparison_text(report, series.first, values.size(), report.scale->of,
                          [&](size_t i) { return values[i - series.first]; });
  text += name_cell("time ~ value^exponent") + format("%10s%10s%10s%8s%8s%10s%12s\n", "at first",
                                                      "at last", "exponent", "+-", "R^2", "a ms",
                                                      "b ms");
  for (const ScaleFit& fit : series.fits) {
    text += name_cell(fit.group) + format("%10.3f%10.3f", fit.first_ms, fit.last_ms);
    if (fit.power)
      text += format("%10.3f", fit.power->exponent) +
              or_dash("%8.3f", 8, fit.power->exponent_error) +
              or_dash("%8.3f", 8, fit.power->r_squared);
    if (fit.line) text += format("%10.3f%12.3g", fit.line->constant, fit.line->slope);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string bench_text(const BenchReport& report) {
  const std::vector<Candidate>& candidates = report.candidates;
  const Candidate& first = candidates.front();
  std::string text = "lueur " LUEUR_VERSION " on " + printable(report.device.name) +
                     ", medians of " + std::to_string(report.frames) + " frames\n";
  if (report.scale) {
    for (const Series& series : report.series) text += series_text(report, series);
    text += "time = a + b * value; +- is the standard error of the exponent";
    text += report.scale->of == "pixels" ? "; value: width * height\n" : "\n";
  } else {
    text += printable(first.scene->name) + ", " + std::to_string(first.scene->triangles) +
            " triangles, " + size_text(first.shot.extent) + "\n";
    for (size_t i = 0; i < candidates.size(); ++i)
      text += printable(candidates[i].label) + "\n" + run_text(candidates[i], report.summaries[i]);
    if (candidates.size() > 1)
      text += comparison_text(report, 0, candidates.size(), "timed in turn, ms",
                              [&](size_t i) { return candidates[i].label; });
  }
  if (candidates.size() > 1)
    text += format("technique, most over least: %.3f\n", max_over_min(report.summaries));
  return text + format("memory of all: %.1f MiB, at most %.1f MiB\n",
                       static_cast<double>(report.memory.total_bytes) / kBytesPerMiB,
                       static_cast<double>(report.memory.peak_bytes) / kBytesPerMiB);
}

}  // namespace lueur::cli
