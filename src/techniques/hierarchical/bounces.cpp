// SPDX-License-Identifier: MIT
// FDP 4, "multi-bounce computation", and the ways of section 5.3 to make it cheap.
#include "techniques/hierarchical/hierarchical_frame.h"

namespace lueur::hierarchical {

// The light of one bounce more is what surfaces reflect of the bounce before.
Gathered HierarchicalFrame::gather_bounces(const Pyramid& pyramid, Image albedo) {
  const Extent extent = pyramid.finest().extent;
  Gathered sum = gather_all_levels(pyramid);
  Image latest = sum.light;
  for (int32_t bounce = 2; bounce <= settings_.bounces && !frame_.failed(); ++bounce) {
    const Pyramid reflected = with_source(pyramid, reflect(pyramid, albedo, latest, false));
    if (latest.index != sum.light.index) frame_.release(latest);
    latest = gather_all_levels(reflected).light;
    release_sources(reflected);
    const Image both = add("hierarchical.bounces", extent, sum.light, latest);
    frame_.release(sum.light);
    sum.light = both;
  }
  if (latest.index != sum.light.index) frame_.release(latest);
  return sum;
}

void HierarchicalFrame::feed_back(Pyramid& pyramid, Image albedo, const Warped& warped) {
  if (!warped.light.valid()) return;
  const Image source = reflect(pyramid, albedo, warped.light, true);
  frame_.release(pyramid.levels[0].source);
  pyramid.levels[0].source = source;
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
    sum = gather_all_levels(reflected);
    release_sources(reflected);
    first = carry(pyramid, "first bounce", first_before);
    second = blend(pyramid, "second bounce", second_before, sum.light);
  } else {
    sum = gather_all_levels(pyramid);
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
