// SPDX-License-Identifier: MIT
// What is timed against each other: a scene, a size and a technique with its settings.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf_load.h"
#include "session.h"
#include "technique_list.h"

namespace lueur::cli {

// A scene on the device, once for all candidates that show it.
struct SceneUnderTest {
  std::string name;  // as given
  uint64_t triangles = 0;
  Cameras cameras;
  float exposure_ev = 0.0f;  // that the scene asks for; 0 where it asks for none
  uint64_t bytes = 0;        // of device memory
  std::unique_ptr<Renderer> renderer;
};

// In bytes of device memory.
struct CandidateMemory {
  uint64_t technique = 0;  // what a frame needs with the technique and not without it
  uint64_t total = 0;      // scene, renderer and technique, as if no other candidate was there
};

struct Candidate {
  // No two of those timed together share one: what a technique remembers of its last frame is kept
  // by it.
  std::string label;
  std::shared_ptr<SceneUnderTest> scene;
  ChosenTechnique technique;
  Shot shot;
  CandidateMemory memory;
};

// What a candidate is made from, checked as far as that goes without a device.
struct CandidateRequest {
  std::string label;
  std::string scene;
  Extent size;
  ChosenTechnique technique;
  EnvironmentChoice environment;  // the same for all requests of one scene
  LoadLimits limits = {};
};

// Whether CandidateMemory is wanted. To measure it takes two frames of each candidate.
enum class MemoryReport : uint8_t { measured, none };

// Loads each scene once, says its warnings, and measures each candidate's memory if that is wanted.
// From then on the recorder keeps all images, so that candidates that take turns do not allocate.
Result<std::vector<Candidate>> make_candidates(Session& session,
                                               std::vector<CandidateRequest> requests,
                                               const std::string& camera, uint32_t seed,
                                               const std::vector<std::string>& side_cameras = {},
                                               MemoryReport report = MemoryReport::measured);

// One frame of a candidate.
Result<FrameRecord> render_candidate(Session& session, Candidate& candidate,
                                     const ImageNames& images);

// How many samples the pass "hierarchical.gather@K" takes: pixels of level K times samples a pixel.
// None for other passes, and where every pixel of the ring is a sample.
std::optional<uint64_t> samples_of(const std::string& pass, const Candidate& candidate);

}  // namespace lueur::cli
