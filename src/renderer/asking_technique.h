// SPDX-License-Identifier: MIT
// For tests: a technique that does what it is told with what the renderer gives it.
#pragma once

#include <functional>
#include <utility>

#include "lueur/technique.h"

namespace lueur {

class AskingTechnique final : public Technique {
 public:
  explicit AskingTechnique(std::function<void(Frame&, const Inputs&)> ask) : ask_(std::move(ask)) {}
  Outputs render(Frame& frame, const Inputs& inputs) override {
    ask_(frame, inputs);
    return {};
  }
  void* settings() override { return nullptr; }

 private:
  std::function<void(Frame&, const Inputs&)> ask_;
};

}  // namespace lueur
