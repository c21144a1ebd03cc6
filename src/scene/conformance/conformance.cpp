// SPDX-License-Identifier: MIT
#include "scene/conformance/conformance.h"

#include "scene/conformance/rules.h"
#include "scene/conformance/schema.h"

namespace lueur::conformance {
namespace {

std::string_view name_of(ViewUse use) {
  switch (use) {
    case ViewUse::none:
      break;
    case ViewUse::vertices:
      return "vertices";
    case ViewUse::indices:
      return "indices";
    case ViewUse::image:
      return "an image";
    case ViewUse::other:
      return "other data";
  }
  return "nothing";
}

std::vector<ViewUse> uses_from_targets(const Json& views) {
  constexpr uint64_t kArrayBuffer = 34962, kElementArrayBuffer = 34963;
  std::vector<ViewUse> uses(views.size(), ViewUse::none);
  for (size_t i = 0; i < views.size(); ++i) {
    const uint64_t target = whole_number(views[i], "target").value_or(0);
    if (target == kArrayBuffer) uses[i] = ViewUse::vertices;
    if (target == kElementArrayBuffer) uses[i] = ViewUse::indices;
  }
  return uses;
}

std::set<std::string_view> strings_of(const Json& names) {
  std::set<std::string_view> strings;
  for (const Json& name : names)
    if (name.is_string()) strings.insert(name.get_ref<const std::string&>());
  return strings;
}

}  // namespace

void Asset::use_view(size_t view, ViewUse use, const std::string& path) {
  ViewUse& known = view_uses[view];
  if (known == ViewUse::none) known = use;
  if (known != use)
    add(path, "reads " + path_to("bufferViews", view) + " as " + std::string(name_of(use)) +
                  ", which holds " + std::string(name_of(known)));
}

void Asset::use_accessor(size_t accessor, ViewUse use, const std::string& path) {
  const std::optional<size_t> view = accessors[accessor].view;
  if (!view) return;
  use_view(*view, use, path);
  if (use != ViewUse::vertices && has(list_of("bufferViews")[*view], "byteStride"))
    add(path, path_to("bufferViews", *view) + " has a byteStride, which only vertices may have");
}

void check_extension_lists(Asset& asset) {
  const Json& required = asset.list_of("extensionsRequired");
  for (size_t i = 0; i < required.size(); ++i)
    if (required[i].is_string() && !asset.uses_extension(required[i].get_ref<const std::string&>()))
      asset.add(path_to("extensionsRequired", i), "is not listed in extensionsUsed");
  // Without quantization known, a reader would take the integers for something else.
  constexpr const char* kQuantization = "KHR_mesh_quantization";
  if (!asset.uses_extension(kQuantization) || strings_of(required).contains(kQuantization)) return;
  const Json& used = asset.list_of("extensionsUsed");
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i] == kQuantization)
      asset.add(path_to("extensionsUsed", i),
                "this extension has to be in extensionsRequired, too");
}

}  // namespace lueur::conformance

namespace lueur {

std::vector<std::string> conformance_faults(const GltfFile& file) {
  using namespace conformance;
  Findings findings;
  for (const std::string& fault : file.container_faults()) findings.add("", fault);
  check_schema(file.root(), findings);

  AccessorTable accessors(file);
  Asset asset{file,
              file.json(),
              accessors,
              findings,
              uses_from_targets(list(file.json(), "bufferViews")),
              strings_of(list(file.json(), "extensionsUsed"))};
  check_extension_lists(asset);
  check_buffers(asset);
  check_accessors(asset);
  check_meshes(asset);
  check_vertices(asset);
  check_nodes(asset);
  check_skins(asset);
  check_animations(asset);
  check_images(asset);
  check_cameras_and_lights(asset);
  check_materials(asset);
  return findings.take();
}

}  // namespace lueur
