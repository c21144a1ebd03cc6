// SPDX-License-Identifier: MIT
// FDP 4, "multi-bounce computation", and the ways of section 5.3 to make it cheap.
#include "techniques/hierarchical/hierarchical_frame.h"

namespace lueur::hierarchical {

bool HierarchicalFrame::further_are_blocked() const {
  return settings_.visibility == Settings::Visibility::all_bounces;
}

// From what the camera sees, or from what the lights see. The camera then gives only what glows.
Gathered HierarchicalFrame::gather_first_bounce(const Pyramid& pyramid) {
  const bool by_lights =
      settings_.sources == Settings::Sources::lights && !inputs_.host->lights().empty();
  if (!by_lights) {
    Gathered sum = gather_all_levels(pyramid, true);
    sum.light = with_side_views(pyramid, sum.light);
    if (settings_.off_screen == Settings::OffScreen::map)
      sum.light = with_off_screen(pyramid, sum.light);
    return sum;
  }
  Gathered sum = gather_from_lights(pyramid);
  const Level& finest = pyramid.finest();
  sum.light = filter(finest, 0, "light_", sum.light);
  if (pyramid.is_dark || frame_.failed()) return sum;
  const Gathered glow = gather_all_levels(pyramid, true);
  const Image both = add("hierarchical.glow", finest.extent, sum.light, glow.light);
  frame_.release(sum.light);
  frame_.release(glow.light);
  return {.light = both, .levels = sum.levels};
}

// The light of one bounce more is what surfaces reflect of the bounce before.
Gathered HierarchicalFrame::gather_bounces(const Pyramid& pyramid, Image albedo) {
  const Extent extent = pyramid.finest().extent;
  Gathered sum = gather_first_bounce(pyramid);
  Image latest = sum.light;
  for (int32_t bounce = 2; bounce <= settings_.bounces && !frame_.failed(); ++bounce) {
    const Pyramid reflected = with_source(pyramid, reflect(pyramid, albedo, latest, false));
    const Image next = gather_all_levels(reflected, further_are_blocked()).light;
    release_sources(reflected);
    if (bounce > 2) frame_.release(latest);
    if (bounce > 2) frame_.release(sum.but_last);
    latest = next;
    sum.but_last = sum.light;
    sum.light = add("hierarchical.bounces", extent, sum.but_last, latest);
  }
  if (sum.but_last.valid()) frame_.release(latest);
  return sum;
}

void HierarchicalFrame::feed_back(Pyramid& pyramid, Image albedo, const Warped& warped) {
  if (!warped.light.valid()) return;
  const Image source = reflect(pyramid, albedo, warped.light, !pyramid.is_dark);
  frame_.release(pyramid.levels[0].source);
  pyramid.levels[0].source = source;
  pyramid.is_dark = false;
}

Gathered HierarchicalFrame::gather_in_turn(const Pyramid& pyramid, Image albedo,
                                           bool second_bounce) {
  const Warped first_before = warp(pyramid, "first bounce");
  const Warped second_before = warp(pyramid, "second bounce");
  Gathered sum;
  Image first, second;
  if (second_bounce && first_before.light.valid()) {
    const Pyramid reflected =
        with_source(pyramid, reflect(pyramid, albedo, first_before.light, false));
    sum = gather_all_levels(reflected, further_are_blocked());
    release_sources(reflected);
    first = carry(pyramid, "first bounce", first_before);
    second = blend(pyramid, "second bounce", second_before, sum.light);
  } else {
    sum = gather_first_bounce(pyramid);
    first = blend(pyramid, "first bounce", first_before, sum.light);
    second = carry(pyramid, "second bounce", second_before);
  }
  frame_.release(sum.light);
  sum.light = add("hierarchical.bounces", pyramid.finest().extent, first, second);
  for (const Image image : {first, second, first_before.light, second_before.light})
    frame_.release(image);
  return sum;
}

}  // namespace lueur::hierarchical
