// SPDX-License-Identifier: MIT
// The Khronos validator's corpus: files with one fault each, beside what the validator says of
// them. All that it calls erroneous has to be refused or warned about, by a line that names
// the place; what it finds no error in has to load, without a word that the validator would not
// say.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/file.h"
#include "scene/conformance/conformance.h"
#include "scene/gltf_load.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

constexpr double kMaxSeconds = 2.0;
constexpr long kMaxKib = 512 * 1024;

struct Outcome {
  bool ended = false;  // by itself, without a crash
  bool loaded = false;
  std::string text;  // warnings, or the refusal
  double seconds = 0.0;
  long peak_kib = 0;
};

// Loads a file in a process of its own, so that its memory can be told.
Outcome load_apart(const fs::path& path) {
  Outcome outcome;
  int ends[2];
  if (pipe(ends) != 0) return outcome;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    const auto scene = load_gltf(path);
    std::string text = scene.ok() ? "L\n" : "R\n" + scene.error().message + "\n";
    if (scene.ok())
      for (const std::string& line : scene->warnings) text += line + "\n";
    const bool written = write(ends[1], text.data(), text.size()) == ssize_t(text.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  char part[4096];
  for (ssize_t size; (size = read(ends[0], part, sizeof part)) > 0;)
    outcome.text.append(part, static_cast<size_t>(size));
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  outcome.ended = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  outcome.loaded = outcome.text.starts_with("L\n");
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.peak_kib = usage.ru_maxrss;
  return outcome;
}

// "/meshes/0/primitives/1/mode" as our lines have it: "meshes[0].primitives[1].mode".
std::string path_of_pointer(const std::string& pointer) {
  std::string path;
  for (size_t at = 0; at < pointer.size();) {
    const size_t end = std::min(pointer.find('/', at + 1), pointer.size());
    const std::string part = pointer.substr(at + 1, end - at - 1);
    const bool is_index =
        !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    path += is_index ? "[" + part + "]" : (path.empty() ? "" : ".") + part;
    at = end;
  }
  return path;
}

// Whether a line is about the place of an error: names it, or the object that holds it. A refusal
// may name the kind of thing alone, and faults of container and text have no path.
bool names(const std::string& text, bool is_refusal, const nlohmann::json& message) {
  if (is_refusal && text.find("the JSON holds a number that is out of range") != std::string::npos)
    return message["code"] == "VALUE_NOT_IN_RANGE";
  const std::string path = path_of_pointer(message.value("pointer", ""));
  if (path.empty())
    return text.find("GLB") != std::string::npos || text.find("JSON") != std::string::npos ||
           text.find("asset") != std::string::npos;
  if (text.find(path) != std::string::npos) return true;
  const size_t dot = path.rfind('.');
  if (dot != std::string::npos && text.find(path.substr(0, dot)) != std::string::npos) return true;
  return is_refusal && text.find(path.substr(0, path.find_first_of("[."))) != std::string::npos;
}

struct Case {
  fs::path path;
  nlohmann::json messages;
  bool has_errors = false;
};

std::vector<Case> cases(const fs::path& folder) {
  std::vector<Case> result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    constexpr std::string_view kSuffix = ".report.json";
    const std::string name = entry.path().string();
    if (!name.ends_with(kSuffix)) continue;
    const fs::path file = name.substr(0, name.size() - kSuffix.size());
    const auto bytes = read_file(entry.path(), 1u << 24);
    if (!fs::exists(file) || !bytes.ok()) continue;
    const auto report = nlohmann::json::parse(*bytes);
    result.push_back({file, report["issues"]["messages"], report["issues"]["numErrors"] > 0});
  }
  return result;
}

class GltfConformanceCorpus : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("LUEUR_DATA");
    if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
    folder_ = fs::path(data) / "gltf_invalid";
  }
  fs::path folder_;
};

TEST_F(GltfConformanceCorpus, ErroneousFilesAreRefusedOrWarnedAbout) {
  int erroneous = 0, refused = 0, warned = 0;
  for (const Case& one : cases(folder_ / "khronos-validator")) {
    if (!one.has_errors) continue;
    ++erroneous;
    const Outcome outcome = load_apart(one.path);
    bool named = false;
    for (const auto& message : one.messages)
      named = named || (message["severity"] == 0 && names(outcome.text, !outcome.loaded, message));
    if (named) ++(outcome.loaded ? warned : refused);
    if (!named)
      std::printf("silent: %s\n%s", fs::relative(one.path, folder_).c_str(), outcome.text.c_str());
  }
  std::printf("%d erroneous files: %d refused, %d warned about\n", erroneous, refused, warned);
  ASSERT_GT(erroneous, 200);
  EXPECT_EQ(refused + warned, erroneous);
}

TEST_F(GltfConformanceCorpus, CleanFilesLoadWithoutFalseAlarms) {
  // Clean, but not for us: a file that asks for glTF 2.1, and one whose buffer is on the network.
  const std::set<std::string> unsupported{"min_version_valid.gltf", "non_relative_uri.gltf"};
  int clean = 0, refused = 0, warned = 0;
  for (const Case& one : cases(folder_ / "khronos-validator")) {
    if (one.has_errors) continue;
    ++clean;
    const Outcome outcome = load_apart(one.path);
    if (!outcome.loaded) {
      ++refused;
      EXPECT_TRUE(unsupported.contains(one.path.filename())) << one.path << outcome.text;
      std::printf("refused: %s", outcome.text.c_str());
      continue;
    }
    const auto file = GltfFile::open(one.path, LoadLimits());
    ASSERT_TRUE(file.ok());
    const std::vector<std::string> lines = conformance_faults(*file);
    warned += lines.empty() ? 0 : 1;
    for (const std::string& line : lines) {
      bool known = false;
      for (const auto& message : one.messages) known = known || names(line, false, message);
      EXPECT_TRUE(known) << one.path << ": " << line;
    }
  }
  std::printf("%d clean files: %d refused, %d warned about as the validator does\n", clean, refused,
              warned);
  ASSERT_GT(clean, 100);
}

TEST_F(GltfConformanceCorpus, EveryFileIsQuickAndSmall) {
  int count = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    ++count;
    const Outcome outcome = load_apart(entry.path());
    EXPECT_TRUE(outcome.ended) << entry.path();
    EXPECT_LT(outcome.seconds, kMaxSeconds) << entry.path();
    EXPECT_LT(outcome.peak_kib, kMaxKib) << entry.path();
  }
  ASSERT_GT(count, 300);
}

}  // namespace
}  // namespace lueur
