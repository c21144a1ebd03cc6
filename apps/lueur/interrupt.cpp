// SPDX-License-Identifier: MIT
#include "interrupt.h"

#include <pthread.h>

#include <ctime>

namespace lueur::cli {

InterruptWatch::InterruptWatch() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &set, &before_);
  watcher_ = std::jthread([this, set](const std::stop_token& end) {
    constexpr timespec kPatience{0, 50'000'000};
    while (!end.stop_requested() && !wish_.stop_requested())
      if (::sigtimedwait(&set, nullptr, &kPatience) > 0) wish_.request_stop();
    // From here on a signal does what it always does, to the thread that still takes it.
    if (wish_.stop_requested()) ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    while (!end.stop_requested()) ::nanosleep(&kPatience, nullptr);
  });
}

InterruptWatch::~InterruptWatch() {
  watcher_.request_stop();
  watcher_.join();
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace lueur::cli
