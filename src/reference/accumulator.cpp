// SPDX-License-Identifier: MIT
#include "reference/accumulator.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/check.h"
#include "image/exposure.h"

namespace lueur::reference {
namespace {

constexpr char kMagic[8] = {'l', 'u', 'e', 'u', 'r', 'r', 'f', '1'};

// What stands before the sums; a checksum of everything stands after them.
struct Header {
  char magic[8] = {};
  char key[32] = {};
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t passes = 0;
  uint32_t reserved = 0;
};

}  // namespace

Accumulator::Accumulator(uint32_t width, uint32_t height)
    : width_(width), height_(height), pixels_(size_t{width} * height) {}

void Accumulator::add_pass(const std::vector<PathSample>& means) {
  LUEUR_CHECK_OP(means.size(), ==, pixels_.size());
  for (size_t i = 0; i < means.size(); ++i) {
    Sums& sums = pixels_[i];
    for (int c = 0; c < 3; ++c) {
      const auto diffuse = static_cast<double>(means[i].diffuse[c]);
      sums.diffuse[c] += diffuse;
      sums.diffuse_squared[c] += diffuse * diffuse;
      sums.specular[c] += static_cast<double>(means[i].specular[c]);
    }
  }
  ++passes_;
}

ImageF Accumulator::mean_of(const double (Sums::*sums)[3]) const {
  ImageF image(width_, height_, 3);
  for (size_t i = 0; i < pixels_.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      image.samples[3 * i + c] = static_cast<float>((pixels_[i].*sums)[c] / std::max(passes_, 1u));
  return image;
}

ImageF Accumulator::diffuse() const {
  return mean_of(&Sums::diffuse);
}

ImageF Accumulator::specular() const {
  return mean_of(&Sums::specular);
}

double Accumulator::variance_of(const Sums& sums, int channel) const {
  if (passes_ < 2) return 0.0;
  const double n = passes_;
  const double mean = sums.diffuse[channel] / n;
  const double of_a_pass =
      std::max(sums.diffuse_squared[channel] - n * mean * mean, 0.0) / (n - 1.0);
  return of_a_pass / n;
}

ImageF Accumulator::variance() const {
  ImageF image(width_, height_, 3);
  for (size_t i = 0; i < pixels_.size(); ++i)
    for (int c = 0; c < 3; ++c)
      image.samples[3 * i + static_cast<size_t>(c)] =
          static_cast<float>(variance_of(pixels_[i], c));
  return image;
}

double Accumulator::relative_error() const {
  if (passes_ < 2) return std::numeric_limits<double>::infinity();
  // Luminance, channels taken as fully correlated: the larger of the possible errors.
  constexpr double kWeights[3] = {0.2126, 0.7152, 0.0722};
  double variance = 0.0, mean = 0.0;
  for (const Sums& sums : pixels_) {
    double deviation = 0.0;
    for (int c = 0; c < 3; ++c) {
      deviation += kWeights[c] * std::sqrt(variance_of(sums, c));
      mean += kWeights[c] * sums.diffuse[c] / passes_;
    }
    variance += deviation * deviation;
  }
  const auto count = static_cast<double>(pixels_.size());
  return mean > 0.0 ? std::sqrt(variance / count) / (mean / count) : 0.0;
}

std::vector<uint8_t> Accumulator::to_bytes(const std::string& key) const {
  Header header{.width = width_, .height = height_, .passes = passes_};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  LUEUR_CHECK_OP(key.size(), ==, sizeof(header.key));
  std::memcpy(header.key, key.data(), sizeof(header.key));
  const size_t sums_bytes = pixels_.size() * sizeof(Sums);
  std::vector<uint8_t> bytes(sizeof(Header) + sums_bytes + sizeof(XXH64_hash_t));
  std::memcpy(bytes.data(), &header, sizeof(header));
  if (sums_bytes > 0) std::memcpy(bytes.data() + sizeof(header), pixels_.data(), sums_bytes);
  const size_t covered = bytes.size() - sizeof(XXH64_hash_t);
  const XXH64_hash_t checksum = XXH3_64bits(bytes.data(), covered);
  std::memcpy(bytes.data() + covered, &checksum, sizeof(checksum));
  return bytes;
}

Result<void> Accumulator::from_bytes(std::span<const uint8_t> bytes, const std::string& key) {
  const auto refused = [](const char* why) {
    return Error{ErrorKind::input,
                 std::string("the stored state ") + why +
                     "; start anew without --resume, or give what it was made for"};
  };
  const size_t expected = sizeof(Header) + pixels_.size() * sizeof(Sums) + sizeof(XXH64_hash_t);
  Header header;
  if (bytes.size() < sizeof(Header)) return refused("is damaged");
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (std::memcmp(header.magic, kMagic, sizeof(kMagic)) != 0)
    return refused("is not a reference's, or of another version");
  if (key.compare(0, key.size(), header.key, sizeof(header.key)) != 0)
    return refused("belongs to another scene, camera, size or setting");
  XXH64_hash_t checksum = 0;
  if (bytes.size() != expected || header.width != width_ || header.height != height_)
    return refused("is damaged");
  const size_t covered = bytes.size() - sizeof(checksum);
  std::memcpy(&checksum, bytes.data() + covered, sizeof(checksum));
  if (checksum != XXH3_64bits(bytes.data(), covered)) return refused("is damaged");
  passes_ = header.passes;
  if (!pixels_.empty())
    std::memcpy(pixels_.data(), bytes.data() + sizeof(header), pixels_.size() * sizeof(Sums));
  return {};
}

}  // namespace lueur::reference
