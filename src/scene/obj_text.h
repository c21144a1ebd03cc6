// SPDX-License-Identifier: MIT
// The lines of an OBJ or MTL file as words, with strict numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"

namespace lueur {

// A finite number that takes the whole word; none otherwise.
std::optional<float> number_of(std::string_view word);
// A whole number that takes the whole word, with or without a sign.
std::optional<int64_t> integer_of(std::string_view word);

class ObjLines {
 public:
  // `text` must outlive this. `file` names it in messages. A line holds `max_words` at most.
  ObjLines(std::string_view text, std::string file, size_t max_words);

  // Goes on to the next line that holds words; false at the end. Comments are passed over, and a
  // backslash at its end joins a line with the next.
  Result<bool> next();

  // Never empty after next() said true; the first is the keyword.
  std::span<const std::string_view> words() const { return words_; }
  // The line from word `first` to its end: names may have spaces in them. Empty if there is none.
  std::string_view rest_from(size_t first) const;
  // The words after the keyword as numbers, at least `least` of them, `values.size()` at most; how
  // many there were.
  Result<size_t> numbers(std::span<float> values, size_t least) const;

  const std::string& file() const { return file_; }
  uint64_t line() const { return line_; }
  // "file: line 12: what"
  Error error(const std::string& what) const { return error_at(line_, what); }
  Error error_at(uint64_t line, const std::string& what) const;

 private:
  std::string_view take_line();

  std::string_view rest_;
  std::string file_;
  size_t max_words_;
  std::vector<std::string_view> words_;
  uint64_t line_ = 0;       // where the current one begins, from 1
  uint64_t next_line_ = 1;  // where the next one begins
};

}  // namespace lueur
