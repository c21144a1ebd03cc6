// SPDX-License-Identifier: MIT
// Runs the program as a user or a script would.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"

namespace lueur {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

struct Ended {
  int code = -1;            // -1: by a signal
  uint64_t peak_bytes = 0;  // of memory that it held at once
  std::string out;
  std::string err;
};

inline std::string text_of(const fs::path& path) {
  const auto bytes = read_file(path, uint64_t{1} << 30);
  return bytes.ok() ? std::string(bytes->begin(), bytes->end()) : std::string();
}

inline size_t line_count(const std::string& text) {
  return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Each test works in an empty folder of its own. Compiled pipelines are kept from test to test, in
// a folder beside it, and not where the user's are.
class Cli : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string name = (fs::temp_directory_path() / "lueur_cli_test_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    base_ = name;
  }
  static void TearDownTestSuite() { fs::remove_all(base_); }

  void SetUp() override {
    folder_ = base_ / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Runs the program in the folder. Its stdout goes to the file `out`; "" closes it.
  Ended run(const Arguments& arguments, const std::string& out = "stdout") const {
    return run_other(LUEUR_PROGRAM, arguments, out);
  }

  // Runs any program, found as the shell finds it, the same way. One that is missing ends with 127;
  // one that takes more than `limit_s` seconds is ended by a signal, unless that is 0.
  Ended run_other(const std::string& program, const Arguments& arguments,
                  const std::string& out = "stdout", unsigned limit_s = 0) const {
    return end(start(program, arguments, out, limit_s), out);
  }

  // The two halves of run_other(): begins, and waits for the end.
  pid_t start(const std::string& program, const Arguments& arguments,
              const std::string& out = "stdout", unsigned limit_s = 0) const {
    const std::string cache = (base_ / "cache").string();
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(folder_.c_str()) != 0) ::_exit(126);
      ::setenv("XDG_CACHE_HOME", cache.c_str(), 1);
      // Vulkan drivers keep memory until the process ends; under AddressSanitizer that would count.
      ::setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
      const int err = ::open("stderr", O_WRONLY | O_CREAT | O_TRUNC, 0600);
      ::dup2(err, STDERR_FILENO);
      ::close(STDOUT_FILENO);
      if (!out.empty() && ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600) != STDOUT_FILENO)
        ::_exit(126);
      ::alarm(limit_s);  // outlives exec
      ::execvp(program.c_str(), argv.data());
      ::_exit(127);
    }
    return child;
  }
  Ended end(pid_t child, const std::string& out = "stdout") const {
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    Ended ended;
    ended.peak_bytes = static_cast<uint64_t>(usage.ru_maxrss) * 1024;
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (out == "stdout") ended.out = text_of(folder_ / "stdout");
    ended.err = text_of(folder_ / "stderr");
    fs::remove(folder_ / "stdout");
    fs::remove(folder_ / "stderr");
    return ended;
  }

  // Expects the exit code, nothing on stdout, and one line on stderr that holds `part`.
  void expect_error(int code, const Arguments& arguments, const std::string& part = "") const {
    const Ended ended = run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += " '" + argument + "'";
    EXPECT_EQ(ended.code, code) << line << "\n" << ended.err;
    EXPECT_EQ(ended.out, "") << line;
    EXPECT_EQ(line_count(ended.err), 1u) << line << "\n" << ended.err;
    EXPECT_TRUE(ended.err.starts_with("lueur: error: ")) << ended.err;
    EXPECT_NE(ended.err.find(part), std::string::npos) << part << " is not in " << ended.err;
  }

  Ended render(Arguments more) const {
    Arguments arguments = {"render", "cornell", "--size", "64x36"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  size_t file_count() const {
    return static_cast<size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  static inline fs::path base_;  // NOLINT(readability-identifier-naming): a static member
  fs::path folder_;
};

}  // namespace lueur
