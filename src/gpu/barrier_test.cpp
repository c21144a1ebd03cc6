// SPDX-License-Identifier: MIT
#include "gpu/barrier.h"

#include <gtest/gtest.h>

namespace lueur::gpu {
namespace {

TEST(Barrier, FirstWriteOfAnImageOnlySetsTheLayout) {
  AccessState state;
  const auto t = advance(state, info(Use::compute_storage_write), true, true);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(t->source_stage, VK_PIPELINE_STAGE_2_NONE);
  EXPECT_EQ(t->old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(t->new_layout, VK_IMAGE_LAYOUT_GENERAL);
}

TEST(Barrier, ReadAfterWriteWaitsOnceAndOnlyOnce) {
  AccessState state;
  advance(state, info(Use::compute_storage_write), true, true);
  const auto first = advance(state, info(Use::compute_storage_read), true, false);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->source_stage, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
  EXPECT_TRUE(first->source_access & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  EXPECT_FALSE(advance(state, info(Use::compute_storage_read), true, false).has_value());
}

TEST(Barrier, ReadInAnotherStageStillSeesTheWrite) {
  AccessState state;
  advance(state, info(Use::color_attachment), true, true);
  advance(state, info(Use::compute_sampled), true, false);
  const auto t = advance(state, info(Use::graphics_sampled), true, false);
  ASSERT_TRUE(t.has_value()) << "the fragment stage never waited for the write";
  EXPECT_EQ(t->old_layout, t->new_layout);
}

TEST(Barrier, WriteAfterReadWaitsForTheReaders) {
  AccessState state;
  advance(state, info(Use::compute_storage_write), true, true);
  advance(state, info(Use::compute_storage_read), true, false);
  const auto t = advance(state, info(Use::copy_target), true, false);
  ASSERT_TRUE(t.has_value());
  EXPECT_TRUE(t->source_stage & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
}

TEST(Barrier, WriteAfterWriteIsOrdered) {
  AccessState state;
  advance(state, info(Use::depth_attachment), true, true);
  const auto t = advance(state, info(Use::depth_attachment), true, false);
  ASSERT_TRUE(t.has_value());
  EXPECT_TRUE(t->source_access & VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
}

TEST(Barrier, LayoutChangeBetweenReadsWaitsForTheFirstReader) {
  AccessState state;
  advance(state, info(Use::compute_storage_write), true, true);
  advance(state, info(Use::compute_storage_read), true, false);
  const auto t = advance(state, info(Use::copy_source), true, false);
  ASSERT_TRUE(t.has_value());
  EXPECT_TRUE(t->source_stage & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
  EXPECT_EQ(t->new_layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

TEST(Barrier, DiscardedContentIsNotCarriedOver) {
  AccessState state;
  advance(state, info(Use::compute_storage_write), true, true);
  const auto t = advance(state, info(Use::compute_storage_write), true, true);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(t->old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_NE(t->source_stage, VK_PIPELINE_STAGE_2_NONE) << "the memory is still being written";
}

TEST(Barrier, BufferReadsNeedNoLayout) {
  AccessState state;
  EXPECT_FALSE(advance(state, info(Use::compute_storage_read), false, false).has_value());
  advance(state, info(Use::compute_storage_write), false, false);
  const auto t = advance(state, info(Use::host_read), false, false);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(t->target_stage, VK_PIPELINE_STAGE_2_HOST_BIT);
}

}  // namespace
}  // namespace lueur::gpu
