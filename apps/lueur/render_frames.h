// SPDX-License-Identifier: MIT
// The frames of an animation, rendered with one technique and its memory, and written as they come.
#pragma once

#include <stop_token>

#include "render_report.h"

namespace lueur::cli {

// Renders the frames of job.frames, after job.settle ones that are not written, and fills in the
// report. A stop takes effect between two frames: what is written stays, and report.frames tells
// how many that are. A video then ends there; with no frame at all, or after a failure, it is left
// out.
Result<void> render_frames(const RenderJob& job, Session& session, Renderer& renderer,
                           const Scene& scene, const Cameras& cameras, const std::stop_token& stop,
                           RenderReport& report);

}  // namespace lueur::cli
