// SPDX-License-Identifier: MIT
// Ctrl-C as a wish instead of an end.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace lueur::cli {

// While it lives, SIGINT and SIGTERM ask its token to stop; the second one ends the process as
// usual. Make it before any other thread, as threads inherit what it blocks.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  std::stop_token token() const { return wish_.get_token(); }

 private:
  sigset_t before_{};
  std::stop_source wish_;
  std::jthread watcher_;
};

}  // namespace lueur::cli
