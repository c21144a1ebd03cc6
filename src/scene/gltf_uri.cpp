// SPDX-License-Identifier: MIT
#include "scene/gltf_uri.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "scene/gltf_json.h"

namespace lueur {
namespace fs = std::filesystem;
namespace {

constexpr uint8_t kNotBase64 = 0xff;

constexpr std::array<uint8_t, 256> base64_values() {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<uint8_t, 256> values{};
  for (uint8_t& value : values) value = kNotBase64;
  for (size_t i = 0; i < kAlphabet.size(); ++i)
    values[static_cast<uint8_t>(kAlphabet[i])] = static_cast<uint8_t>(i);
  return values;
}

std::optional<std::vector<uint8_t>> decode_base64(std::string_view text) {
  static constexpr std::array<uint8_t, 256> kValues = base64_values();
  // Drop up to two padding characters; some exporters leave them out altogether.
  for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;

  std::vector<uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : text) {
    const uint8_t value = kValues[static_cast<uint8_t>(c)];
    if (value == kNotBase64) return std::nullopt;
    bits = (bits << 6 | value) & 0xffffu;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> bit_count & 0xffu));
  }
  return bytes;
}

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> percent_decode(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hex_value(text[i + 1]);
    const int low = hex_value(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return out;
}

// `name`, relative to `folder`, if it leads to something inside. `shown` stands for it in messages.
Result<fs::path> confined(const fs::path& folder, const std::string& name,
                          const std::string& shown) {
  const Error outside{ErrorKind::input, shown +
                                            " leads out of the asset's folder; put the file "
                                            "beside the asset and refer to it by name"};
  // Refuse schemes (http:, file:) and drives by the colon before the first slash.
  const size_t colon = name.find(':');
  if (colon != std::string::npos && colon < name.find('/'))
    return Error{ErrorKind::input, shown + ": only data URIs and files beside the asset are read"};
  const fs::path relative(name);
  if (relative.is_absolute()) return outside;

  // Compare after links are resolved, so that a link cannot lead out either.
  std::error_code failure;
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, failure);
  if (failure) return Error{ErrorKind::input, shown + ": " + failure.message()};
  const fs::path target = fs::weakly_canonical(root / relative, failure);
  if (failure) return Error{ErrorKind::input, shown + ": " + failure.message()};
  const auto [root_end, target_at] =
      std::mismatch(root.begin(), root.end(), target.begin(), target.end());
  if (root_end != root.end() || target_at == target.end()) return outside;
  return target;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return uri.starts_with("data:");
}

std::optional<std::string_view> media_type(std::string_view data_uri) {
  constexpr size_t kPrefix = 5;  // "data:"
  const size_t comma = data_uri.find(',');
  if (!is_data_uri(data_uri) || comma == std::string_view::npos) return std::nullopt;
  std::string_view rest = data_uri.substr(kPrefix, comma - kPrefix);
  const std::string_view type = rest.substr(0, rest.find(';'));
  rest.remove_prefix(type.size());
  while (!rest.empty()) {
    const std::string_view parameter = rest.substr(1, rest.find(';', 1) - 1);
    rest.remove_prefix(parameter.size() + 1);
    const bool is_base64 = parameter == "base64" && rest.empty();
    if (!is_base64 && parameter.find('=') == std::string_view::npos) return std::nullopt;
  }
  return type;
}

Result<std::vector<uint8_t>> decode_data_uri(std::string_view uri) {
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos)
    return Error{ErrorKind::input, "malformed data URI; re-export the file"};
  if (!uri.substr(0, comma).ends_with(";base64")) {
    const std::optional<std::string> text = percent_decode(uri.substr(comma + 1));
    if (!text) return Error{ErrorKind::input, "malformed data URI; re-export the file"};
    return std::vector<uint8_t>(text->begin(), text->end());
  }
  std::optional<std::vector<uint8_t>> bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) return Error{ErrorKind::input, "malformed base64; re-export the file"};
  return std::move(*bytes);
}

Result<fs::path> confined_path(const fs::path& folder, std::string_view uri) {
  const std::optional<std::string> decoded = percent_decode(uri);
  if (!decoded || decoded->empty() || decoded->find('\0') != std::string::npos)
    return Error{ErrorKind::input, in_quotes(uri) + " is not a valid URI"};
  return confined(folder, *decoded, in_quotes(uri));
}

Result<fs::path> confined_file(const fs::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  if (name.empty() || name.find('\0') != std::string::npos)
    return Error{ErrorKind::input, in_quotes(name) + " is not a file name"};
  return confined(folder, name, in_quotes(name));
}

}  // namespace lueur
