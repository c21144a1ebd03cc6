// SPDX-License-Identifier: MIT
// Hands an Error on to the caller, so that the good path of a function reads straight down.
#pragma once

#include "lueur/result.h"

// Declares `name` as the value of `expression`, a Result<T>; returns its error from here if it
// failed.
#define LUEUR_TRY(name, expression)                      \
  auto name##_result = (expression);                     \
  if (!name##_result.ok()) return name##_result.error(); \
  auto& name = *name##_result

// The same for a Result<void>.
#define LUEUR_TRY_VOID(expression)                                                   \
  do {                                                                               \
    if (auto try_result = (expression); !try_result.ok()) return try_result.error(); \
  } while (false)
