// SPDX-License-Identifier: MIT
// Direct light of one punctual light, added to the two targets: diffuse source radiance and
// specular, which takes the diffuse light, too, of what passes no light on. The including shader brings `shadow_map` and `float shadow(vec3 position, vec3 normal,
// vec3 to_light, float distance_m)`.
#include "shading/brdf.h"
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

float shadow(vec3 position, vec3 n, vec3 to_light, float distance_m);

// The receiver is moved off its surface, so that a surface does not shade itself. Next to a point a
// plane's depth in the map changes by sin(alpha) cos(phi) / cos(theta) a texel, with alpha between
// normal and `map_axis` (unit, in which the map looks), phi between axis and light ray, theta between
// normal and light ray; an offset o along the normal gains o cos(phi) / cos(theta). The filter reaches
// about 2.5 texels, hence 2.5 sin(alpha), and half a texel for rounding.
vec3 shadow_position(vec3 position, vec3 n, vec3 map_axis, float texel_m) {
  return position + n * (texel_m * (0.5 + 2.5 * length(cross(n, map_axis))));
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
  const vec4 mrs = texelFetch(material, pixel, 0);
  const vec3 diffuse = diffuse_albedo(color, mrs.r) * irradiance / kPi;
  const bool keeps = keeps_light(mrs);
  if (!keeps) {
    vec4 diffuse_sum = imageLoad(source, pixel);
    diffuse_sum.rgb += diffuse;
    imageStore(source, pixel, min(diffuse_sum, vec4(65504.0)));
  }

  const vec3 to_eye = normalize(p.world_from_view[3].xyz - position);
  const float cos_view = max(dot(n, to_eye), 1e-3);
  const vec3 half_way = normalize(to_light + to_eye);
  const vec3 brdf = ggx_brdf(specular_f0(color, mrs.r, mrs.b), specular_f90(mrs.r, mrs.b), mrs.g, cos_light, cos_view,
                             clamp(dot(n, half_way), 0.0, 1.0),
                             clamp(dot(to_light, half_way), 0.0, 1.0));
  vec4 specular_sum = imageLoad(specular, pixel);
  specular_sum.rgb += brdf * irradiance;
  if (keeps) specular_sum.rgb += diffuse;
  imageStore(specular, pixel, min(specular_sum, vec4(65504.0)));
}
