// SPDX-License-Identifier: MIT
#include "scene/texture_decode.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <system_error>
#include <thread>

#include "base/try.h"

namespace lueur {
namespace {

void decode_one(EncodedImage& image) {
  // Catch here: an exception must not leave a thread.
  try {
    if (auto decoded = decode_image(image.bytes, image.header, image.rgba); !decoded.ok())
      image.failure = decoded.error();
  } catch (const std::bad_alloc&) {
    image.failure = Error{ErrorKind::memory, "no memory to decode the image"};
  }
}

}  // namespace

Result<void> read_header(EncodedImage& image, const LoadLimits& limits) {
  // Believe the header only within the limits: memory is taken for what it says.
  LUEUR_TRY(header, read_image_header(image.bytes));
  image.header = header;
  const uint32_t side_limit = limits.texture_side_px;
  if (header.width == 0 || header.height == 0 || header.width > side_limit ||
      header.height > side_limit)
    return Error{ErrorKind::input, std::to_string(header.width) + " x " +
                                       std::to_string(header.height) +
                                       " pixels, sides have to be 1 to " +
                                       std::to_string(side_limit) + "; resize the image"};
  return {};
}

Result<void> decode_all(std::vector<EncodedImage>& images) {
  for (EncodedImage& image : images)
    image.rgba.resize(size_t{image.header.width} * image.header.height * 4);

  std::atomic<size_t> next{0};
  const auto work = [&] {
    for (size_t i = next++; i < images.size(); i = next++) decode_one(images[i]);
  };
  // Let this thread work too: without any helper thread all images are still decoded.
  const size_t helper_count =
      std::min<size_t>(std::max(std::thread::hardware_concurrency(), 1u), images.size());
  {
    std::vector<std::jthread> helpers;
    try {
      for (size_t i = 1; i < helper_count; ++i) helpers.emplace_back(work);
    } catch (const std::system_error&) {
      // No more threads to be had; those that run are enough.
    }
    work();
  }
  for (const EncodedImage& image : images)
    if (image.failure)
      return Error{image.failure->kind,
                   image.path + image.failure->message + "; save the image again"};
  return {};
}

}  // namespace lueur
