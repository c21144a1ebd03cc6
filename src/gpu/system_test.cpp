// SPDX-License-Identifier: MIT
// Choosing a device, and the pipeline cache on disk.
#include "gpu/system.h"

#include <gtest/gtest.h>

#include <cctype>

#include "base/file.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "gpu/shaders.h"

namespace lueur::gpu {
namespace {

std::vector<DeviceEntry> devices() {
  auto listed = System::list_devices();
  EXPECT_TRUE(listed.ok()) << listed.error().message;
  return listed.ok() ? *listed : std::vector<DeviceEntry>{};
}

TEST(System, ListsItsDevices) {
  const auto all = devices();
  ASSERT_FALSE(all.empty());
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].index, i);
    EXPECT_FALSE(all[i].name.empty());
    EXPECT_FALSE(all[i].kind.empty());
    EXPECT_FALSE(all[i].driver.empty());
    EXPECT_GT(all[i].memory_bytes, 0u);
    // The one that renders on the CPU can do all that Lueur needs.
    if (all[i].kind == "CPU") {
      EXPECT_EQ(all[i].missing, std::vector<std::string>{});
    }
  }
}

TEST(System, FindsADeviceByNumberAndByName) {
  for (const DeviceEntry& entry : devices()) {
    if (!entry.missing.empty()) continue;
    const auto by_number = System::create({.device = std::to_string(entry.index)});
    ASSERT_TRUE(by_number.ok()) << by_number.error().message;
    EXPECT_EQ((*by_number)->device().name, entry.name);

    // A part of the name, whatever its case.
    std::string part = entry.name.substr(1, entry.name.size() / 2);
    for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto by_name = System::create({.device = part});
    ASSERT_TRUE(by_name.ok()) << by_name.error().message;
    EXPECT_NE((*by_name)->device().name.find(entry.name.substr(1, 3)), std::string::npos);
  }
}

TEST(System, ChoosesADeviceThatHasAllFeatures) {
  const auto system = System::create({});
  ASSERT_TRUE(system.ok()) << system.error().message;
  EXPECT_TRUE((*system)->device().missing.empty());
  const ContextInfo info = (*system)->context_info();
  EXPECT_TRUE(
      missing_features(info.get_instance_proc_addr, info.instance, info.physical_device).empty());
}

TEST(System, AnUnknownDeviceIsAnErrorThatListsThoseThereAre) {
  const auto all = devices();
  // A number that is too large, and text that starts like a number, are no device either.
  for (const std::string& wanted :
       {std::string("no such device"), std::string("99"), std::string("0x"), std::string("-1")}) {
    const auto system = System::create({.device = wanted});
    ASSERT_FALSE(system.ok()) << wanted;
    EXPECT_EQ(system.error().kind, ErrorKind::usage);
    const std::string& message = system.error().message;
    EXPECT_NE(message.find("--device " + wanted), std::string::npos) << message;
    for (const DeviceEntry& entry : all)
      EXPECT_NE(message.find(std::to_string(entry.index) + " = " + entry.name), std::string::npos)
          << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(System, AnErrorWhileRecordingIsHandedOnAndTheNextRunWorks) {
  const auto system = System::create({});
  ASSERT_TRUE(system.ok()) << system.error().message;
  const auto failed = (*system)->run([](VkCommandBuffer) -> Result<void> {
    return Error{ErrorKind::input, "as told"};
  });
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().message, "as told");
  const auto fine = (*system)->run([](VkCommandBuffer) -> Result<void> { return {}; });
  EXPECT_TRUE(fine.ok());
}

// What the driver was given when the last pipeline cache was made.
std::vector<uint8_t> cache_data;
PFN_vkCreatePipelineCache real_create_cache = nullptr;

VkResult VKAPI_PTR spy_on_cache(VkDevice device, const VkPipelineCacheCreateInfo* info,
                                const VkAllocationCallbacks* allocation, VkPipelineCache* cache) {
  const auto* bytes = static_cast<const uint8_t*>(info->pInitialData);
  cache_data.clear();
  if (info->initialDataSize > 0) cache_data.assign(bytes, bytes + info->initialDataSize);
  return real_create_cache(device, info, allocation, cache);
}

class PipelineCache : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "lueur_pipeline_cache_" +
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    auto system = System::create({});
    ASSERT_TRUE(system.ok()) << system.error().message;
    system_ = std::move(*system);
    auto device = Device::create(system_->context_info());
    ASSERT_TRUE(device.ok()) << device.error().message;
    device_ = std::move(*device);
    real_create_cache = vkCreatePipelineCache;
    vkCreatePipelineCache = spy_on_cache;
  }
  void TearDown() override {
    if (real_create_cache) vkCreatePipelineCache = real_create_cache;
    device_.reset();
    system_.reset();
    std::filesystem::remove_all(folder_);
  }

  std::filesystem::path file() const { return folder_ / "below" / "pipelines.bin"; }
  std::vector<uint8_t> stored() const {
    auto read = read_file(file(), uint64_t{1} << 26);
    return read.ok() ? *read : std::vector<uint8_t>{};
  }
  // One run of a program: makes a pipeline, ends. Returns what the driver was given at its start.
  std::vector<uint8_t> use(const std::filesystem::path& cache_file) {
    PipelineLibrary library(*device_, cache_file);
    auto given = cache_data;
    const auto pipeline = library.compute(shaders::gpu_system_test_comp, {});
    EXPECT_TRUE(pipeline.ok());
    return given;
  }
  // Puts `content` where the cache is; it must not reach the driver, and must be replaced.
  void expect_ignored(const std::vector<uint8_t>& content) {
    ASSERT_TRUE(write_file(file(), content).ok());
    EXPECT_TRUE(use(file()).empty());
    EXPECT_EQ(stored().size(), good_.size());
    EXPECT_EQ(use(file()), stored());
  }

  std::filesystem::path folder_;
  std::unique_ptr<System> system_;
  std::unique_ptr<Device> device_;
  std::vector<uint8_t> good_;
};

TEST_F(PipelineCache, IsWrittenAndUsedAgain) {
  EXPECT_TRUE(use(file()).empty());
  const std::vector<uint8_t> first = stored();
  ASSERT_GE(first.size(), sizeof(VkPipelineCacheHeaderVersionOne));
  EXPECT_EQ(use(file()), first);
}

TEST_F(PipelineCache, IsNotWrittenWithoutAPipelineOrAName) {
  { const PipelineLibrary library(*device_, file()); }
  EXPECT_FALSE(std::filesystem::exists(file()));
  use({});
  EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(PipelineCache, WhatDoesNotFitIsIgnoredAndReplaced) {
  use(file());
  good_ = stored();
  ASSERT_GE(good_.size(), sizeof(VkPipelineCacheHeaderVersionOne));

  // Truncated within the header, empty, and no cache at all.
  expect_ignored({good_.begin(), good_.begin() + 20});
  expect_ignored({});
  expect_ignored(std::vector<uint8_t>(5000, 0xA5));
  // Of another vendor, device, driver, and version of the header.
  for (const size_t byte : {offsetof(VkPipelineCacheHeaderVersionOne, vendorID),
                            offsetof(VkPipelineCacheHeaderVersionOne, deviceID),
                            offsetof(VkPipelineCacheHeaderVersionOne, pipelineCacheUUID),
                            offsetof(VkPipelineCacheHeaderVersionOne, headerVersion)}) {
    SCOPED_TRACE(byte);
    std::vector<uint8_t> foreign = good_;
    foreign[byte] ^= 0x40;
    expect_ignored(foreign);
  }
}

TEST_F(PipelineCache, AFolderThatCannotBeWrittenOnlyCostsTime) {
  // A file stands where the folder would have to be.
  std::filesystem::create_directories(folder_);
  ASSERT_TRUE(write_file(folder_ / "below", std::string_view("in the way")).ok());
  EXPECT_TRUE(use(file()).empty());
}

}  // namespace
}  // namespace lueur::gpu
