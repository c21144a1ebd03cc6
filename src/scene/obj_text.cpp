// SPDX-License-Identifier: MIT
#include "scene/obj_text.h"

#include <charconv>
#include <cmath>

#include "scene/gltf_json.h"

namespace lueur {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

// Whether the line that ends before `end` goes on after it.
bool is_continued(std::string_view text, size_t end) {
  while (end > 0 && text[end - 1] == '\r') --end;
  return end > 0 && text[end - 1] == '\\';
}

std::string_view without_plus(std::string_view word) {
  return word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
}

}  // namespace

std::optional<float> number_of(std::string_view word) {
  word = without_plus(word);
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (stop != end || word.empty()) return std::nullopt;
  // Too small for a double is 0; too large for a float is no number.
  if (failure == std::errc::result_out_of_range) {
    if (word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos)
      return std::nullopt;
    value = 0.0;
  } else if (failure != std::errc()) {
    return std::nullopt;
  }
  const float narrow = static_cast<float>(value);
  return std::isfinite(narrow) ? std::optional(narrow) : std::nullopt;
}

std::optional<int64_t> integer_of(std::string_view word) {
  word = without_plus(word);
  int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  return failure == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

ObjLines::ObjLines(std::string_view text, std::string file, size_t max_words)
    : rest_(text), file_(std::move(file)), max_words_(max_words) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::string_view ObjLines::take_line() {
  line_ = next_line_;
  const size_t first = rest_.find_first_not_of(" \t");
  const bool is_comment = first != std::string_view::npos && rest_[first] == '#';
  size_t end = rest_.find('\n');
  ++next_line_;
  while (end != std::string_view::npos && !is_comment && is_continued(rest_, end)) {
    end = rest_.find('\n', end + 1);
    ++next_line_;
  }
  const std::string_view line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  return line;
}

Result<bool> ObjLines::next() {
  while (!rest_.empty()) {
    const std::string_view line = take_line();
    words_.clear();
    for (size_t i = 0; i < line.size();) {
      // A backslash that joins two lines is a space.
      if (is_space(line[i]) || (line[i] == '\\' && i + 1 < line.size() &&
                                (line[i + 1] == '\n' || line[i + 1] == '\r'))) {
        ++i;
        continue;
      }
      if (line[i] == '#') break;
      size_t end = i;
      while (end < line.size() && !is_space(line[end])) ++end;
      const bool joins = end < line.size() && line[end - 1] == '\\' && end - 1 > i &&
                         (line[end] == '\n' || line[end] == '\r');
      if (words_.size() >= max_words_)
        return error("holds more than " + std::to_string(max_words_) +
                     " words; split the polygon, or raise the limit of its corners");
      words_.push_back(line.substr(i, end - i - (joins ? 1 : 0)));
      i = end;
    }
    if (!words_.empty()) return true;
  }
  return false;
}

std::string_view ObjLines::rest_from(size_t first) const {
  if (first >= words_.size()) return {};
  const char* begin = words_[first].data();
  const char* end = words_.back().data() + words_.back().size();
  return {begin, static_cast<size_t>(end - begin)};
}

Result<size_t> ObjLines::numbers(std::span<float> values, size_t least) const {
  const size_t count = std::min(words_.size() - 1, values.size());
  if (count < least)
    return error(in_quotes(words_[0]) + " needs " + std::to_string(least) + " numbers, " +
                 std::to_string(count) + " are there; export the file again");
  for (size_t i = 0; i < count; ++i) {
    const std::optional<float> value = number_of(words_[i + 1]);
    if (!value)
      return error(in_quotes(words_[i + 1]) + " is not a finite number; export the file again");
    values[i] = *value;
  }
  return count;
}

Error ObjLines::error_at(uint64_t line, const std::string& what) const {
  return {ErrorKind::input, file_ + ": line " + std::to_string(line) + ": " + what};
}

}  // namespace lueur
