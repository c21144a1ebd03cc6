// SPDX-License-Identifier: MIT
// How a public call tells that it failed. No exception and no abort crosses the public API:
// whatever a user, a file, a device or a disk can cause comes back as an Error in a Result.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace lueur {

// What kind of thing has to be put right. The program turns each kind into an exit code.
enum class ErrorKind {
  usage,   // a flag, setting, size or argument: call again, corrected
  input,   // a file that is missing, malformed, hostile or unsupported
  output,  // a file that cannot be written: permissions, missing folder, full disk
  device,  // no device, a device that lacks a feature, or a device that was lost
  memory,  // host or device memory ran out
};

struct Error {
  ErrorKind kind = ErrorKind::usage;
  // One line: names the thing (file, field, flag, device), what is wrong, and the remedy.
  std::string message;
};

// A value, or the reason why there is none. `value()` may be called only if `ok()`.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

// A call that yields nothing but may fail.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace lueur
