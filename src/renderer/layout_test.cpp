// SPDX-License-Identifier: MIT
// The structures of params.h lie in memory as the shaders read them.
#include "support/layout.h"

#include "renderer/params.h"
#include "renderer/shaders.h"

namespace lueur {
namespace {

TEST(RendererLayout, GeometryPasses) {
  for (const gpu::ShaderCode* code :
       {&shaders::renderer_g_buffer_vert, &shaders::renderer_shadow_vert}) {
    expect_layout(
        *code, "instances", sizeof(InstanceData),
        {LUEUR_MEMBER(InstanceData, world_from_object),
         LUEUR_MEMBER(InstanceData, world_from_object_before),
         LUEUR_MEMBER(InstanceData, world_from_object_normal),
         LUEUR_MEMBER(InstanceData, is_deformed), LUEUR_MEMBER(InstanceData, first_deformed),
         LUEUR_MEMBER(InstanceData, surface_bits), LUEUR_MEMBER(InstanceData, object)});
    expect_layout(
        *code, "deformed", sizeof(DeformedVertex),
        {LUEUR_MEMBER(DeformedVertex, position), LUEUR_MEMBER(DeformedVertex, position_before),
         LUEUR_MEMBER(DeformedVertex, normal), LUEUR_MEMBER(DeformedVertex, tangent)});
  }
  for (const gpu::ShaderCode* code :
       {&shaders::renderer_g_buffer_frag, &shaders::renderer_shadow_frag}) {
    expect_layout(
        *code, "materials", sizeof(MaterialData),
        {LUEUR_MEMBER(MaterialData, base_color), LUEUR_MEMBER(MaterialData, emission),
         LUEUR_MEMBER(MaterialData, metallic), LUEUR_MEMBER(MaterialData, roughness),
         LUEUR_MEMBER(MaterialData, specular), LUEUR_MEMBER(MaterialData, normal_scale),
         LUEUR_MEMBER(MaterialData, alpha_cutoff), LUEUR_MEMBER(MaterialData, has_normal_map),
         LUEUR_MEMBER(MaterialData, unlit), LUEUR_MEMBER(MaterialData, cosine_lobe),
         LUEUR_MEMBER(MaterialData, base_color_place),
         LUEUR_MEMBER(MaterialData, metallic_roughness_place),
         LUEUR_MEMBER(MaterialData, normal_place), LUEUR_MEMBER(MaterialData, emission_place)});
    expect_layout(*code, "push", sizeof(DrawParams), {LUEUR_MEMBER(DrawParams, material)});
  }
  expect_layout(shaders::renderer_g_buffer_vert, "params", sizeof(GBufferParams),
                {LUEUR_MEMBER(GBufferParams, clip_from_world),
                 LUEUR_MEMBER(GBufferParams, clip_from_world_before)});
  expect_layout(shaders::renderer_shadow_vert, "params", sizeof(ShadowParams),
                {LUEUR_MEMBER(ShadowParams, clip_from_world)});
}

TEST(RendererLayout, LightPasses) {
  for (const gpu::ShaderCode* code :
       {&shaders::renderer_light_cube_comp, &shaders::renderer_light_flat_comp})
    expect_layout(
        *code, "params", sizeof(LightParams),
        {LUEUR_MEMBER(LightParams, screen), LUEUR_MEMBER(LightParams, world_from_view),
         LUEUR_MEMBER(LightParams, shadow_from_world), LUEUR_MEMBER(LightParams, position_world),
         LUEUR_MEMBER(LightParams, direction_world), LUEUR_MEMBER(LightParams, intensity),
         LUEUR_MEMBER(LightParams, extent), LUEUR_MEMBER(LightParams, kind),
         LUEUR_MEMBER(LightParams, cone_scale), LUEUR_MEMBER(LightParams, cone_offset),
         LUEUR_MEMBER(LightParams, inverse_range), LUEUR_MEMBER(LightParams, shadow_near_m),
         LUEUR_MEMBER(LightParams, texel_m)});
}

TEST(RendererLayout, CosineLobes) {
  for (const gpu::ShaderCode* code :
       {&shaders::renderer_light_cube_comp, &shaders::renderer_light_flat_comp,
        &shaders::renderer_reflectance_comp})
    expect_layout(
        *code, "lobes", sizeof(LobeData),
        {LUEUR_MEMBER(LobeData, color), LUEUR_MEMBER(LobeData, exponent),
         LUEUR_MEMBER(LobeData, c_xy), LUEUR_MEMBER(LobeData, c_z), LUEUR_MEMBER(LobeData, name)});
}

TEST(RendererLayout, Background) {
  expect_layout(shaders::renderer_background_comp, "push", sizeof(BackgroundParams),
                {LUEUR_MEMBER(BackgroundParams, extent), LUEUR_MEMBER(BackgroundParams, everywhere),
                 LUEUR_MEMBER(BackgroundParams, corner), LUEUR_MEMBER(BackgroundParams, step_x),
                 LUEUR_MEMBER(BackgroundParams, step_y), LUEUR_MEMBER(BackgroundParams, level),
                 LUEUR_MEMBER(BackgroundParams, intensity)});
}

TEST(RendererLayout, SurfaceAndComposition) {
  expect_layout(shaders::renderer_surface_comp, "push", sizeof(SurfaceParams),
                {LUEUR_MEMBER(SurfaceParams, extent), LUEUR_MEMBER(SurfaceParams, has_emission)});
  expect_layout(shaders::renderer_passed_on_comp, "push", sizeof(PassedOnParams),
                {LUEUR_MEMBER(PassedOnParams, extent)});
  expect_layout(shaders::renderer_object_comp, "push", sizeof(ObjectParams),
                {LUEUR_MEMBER(ObjectParams, extent)});
  expect_layout(shaders::renderer_reflectance_comp, "push", sizeof(ReflectanceParams),
                {LUEUR_MEMBER(ReflectanceParams, extent)});
  expect_layout(shaders::renderer_compose_comp, "push", sizeof(ComposeParams),
                {LUEUR_MEMBER(ComposeParams, extent), LUEUR_MEMBER(ComposeParams, has_indirect),
                 LUEUR_MEMBER(ComposeParams, has_indirect_specular)});
  expect_layout(shaders::renderer_compose_occluded_comp, "push", sizeof(ComposeOccludedParams),
                {LUEUR_MEMBER(ComposeOccludedParams, extent)});
}

}  // namespace
}  // namespace lueur
