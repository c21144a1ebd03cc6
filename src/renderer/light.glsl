// SPDX-License-Identifier: MIT
// Direct light of one punctual light, added to the two targets: diffuse source radiance and
// specular, which takes the diffuse light, too, of what passes no light on. The including shader
// brings `shadow_map` and `float shadow(vec3 position, vec3 normal, vec3 to_light,
// float distance_m)`.
#include "shading/brdf.h"
#include "shading/cosine_lobe.h"
#include "shading/packing.h"
#include "shading/punctual_light.h"
#include "renderer/params.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D base_color;
layout(set = 0, binding = 3) uniform sampler2D material;
layout(set = 0, binding = 5, rgba16f) uniform image2D source;
layout(set = 0, binding = 6, rgba16f) uniform image2D specular;
layout(set = 0, binding = 7, scalar) uniform Params { LightParams value; } params;
layout(set = 0, binding = 8, scalar) readonly buffer Lobes { LobeData data[]; } lobes;

// Normal maps may turn a surface away from the eye that sees it: it is then seen along itself.
const float kLeastCosView = 1e-3;

float shadow(vec3 position, vec3 n, vec3 to_light, float distance_m);

// The receiver is moved off its surface, so that a surface does not shade itself. Next to a point a
// plane's depth in the map changes by sin(alpha) cos(phi) / cos(theta) a texel, with alpha between
// normal and `map_axis` (unit, in which the map looks), phi between axis and light ray, theta
// between normal and light ray; an offset o along the normal gains o cos(phi) / cos(theta). The
// filter reaches about 2.5 texels, hence 2.5 sin(alpha), and half a texel for rounding.
vec3 shadow_position(vec3 position, vec3 n, vec3 map_axis, float texel_m) {
  return position + n * (texel_m * (0.5 + 2.5 * length(cross(n, map_axis))));
}

// `m`: a texel of `material`. Without the cosine.
vec3 specular_brdf(vec3 color, vec4 m, vec3 n, vec3 to_light, vec3 to_eye) {
  const float cos_view = dot(n, to_eye);
  if (has_cosine_lobe(m)) {
    const LobeData lobe = lobes.data[cosine_lobe_index(m)];
    const vec3 above = normalize(to_eye + max(kLeastCosView - cos_view, 0.0) * n);
    return lobe.color * cosine_lobe(lobe.exponent, lobe.c_xy, lobe.c_z, n, to_light, above);
  }
  const vec3 half_way = normalize(to_light + to_eye);
  return ggx_brdf(specular_f0(color, m.r, m.b), specular_f90(m.r, m.b), m.g, dot(n, to_light),
                  max(cos_view, kLeastCosView), clamp(dot(n, half_way), 0.0, 1.0),
                  clamp(dot(to_light, half_way), 0.0, 1.0));
}

void main() {
  const LightParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const float d = texelFetch(depth, pixel, 0).r;
  if (d == p.screen.depth_of_nothing) return;

  const float z = z_from_depth(p.screen, d);
  const vec3 position_in_view = position_view(ray_through(p.screen, vec2(pixel) + 0.5), z);
  const vec3 position = (p.world_from_view * vec4(position_in_view, 1.0)).xyz;
  const vec3 n = octahedral_decode(texelFetch(normal, pixel, 0).rg);

  // KHR_lights_punctual: irradiance on a surface that faces the light.
  vec3 to_light = -p.direction_world;
  float distance_m = 1.0;
  vec3 irradiance = p.intensity;
  if (p.kind != kLightDirectional) {
    to_light = p.position_world - position;
    distance_m = max(length(to_light), kLeastLightDistance);
    to_light /= distance_m;
    irradiance *= range_window(distance_m, p.inverse_range) / (distance_m * distance_m);
  }
  if (p.kind == kLightSpot)
    irradiance *=
        cone_attenuation(dot(-to_light, p.direction_world), p.cone_scale, p.cone_offset);
  const float cos_light = dot(n, to_light);
  if (cos_light <= 0.0 || all(equal(irradiance, vec3(0.0)))) return;
  irradiance *= cos_light * shadow(position, n, to_light, distance_m);

  const vec3 color = texelFetch(base_color, pixel, 0).rgb;
  const vec4 material_here = texelFetch(material, pixel, 0);
  const vec3 diffuse = diffuse_albedo(color, material_here.r) * irradiance / kPi;
  const bool keeps = keeps_light(material_here);
  if (!keeps) {
    vec4 diffuse_sum = imageLoad(source, pixel);
    diffuse_sum.rgb += diffuse;
    imageStore(source, pixel, min(diffuse_sum, vec4(65504.0)));
  }

  const vec3 to_eye = normalize(p.world_from_view[3].xyz - position);
  vec4 specular_sum = imageLoad(specular, pixel);
  specular_sum.rgb += specular_brdf(color, material_here, n, to_light, to_eye) * irradiance;
  if (keeps) specular_sum.rgb += diffuse;
  imageStore(specular, pixel, min(specular_sum, vec4(65504.0)));
}
