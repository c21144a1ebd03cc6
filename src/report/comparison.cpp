// SPDX-License-Identifier: MIT
#include "report/comparison.h"

#include <algorithm>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"
#include "report/folder.h"
#include "report/packed_picture.h"
#include "report/page.h"
#include "report/page_sources.h"
#include "report/results.h"
#include "report/text.h"

namespace lueur::report {
namespace {

void check_image(const Comparison& comparison, const ImageF& image, uint32_t channels) {
  if (image.samples.empty()) return;
  LUEUR_CHECK_OP(image.width, ==, comparison.width);
  LUEUR_CHECK_OP(image.height, ==, comparison.height);
  LUEUR_CHECK_OP(image.channels, ==, channels);
}

void check_pictures(const Comparison& comparison, const Pictures& pictures) {
  check_image(comparison, pictures.composed, 3);
  check_image(comparison, pictures.indirect, 3);
  check_image(comparison, pictures.occlusion, 1);
}

void check_metric(const Comparison& comparison, const std::string& name) {
  LUEUR_CHECK_OP(std::ranges::count(comparison.metrics, name, &Metric::name), ==, 1);
}

void check_errors(const Comparison& comparison, const Errors& errors) {
  const auto same_label = [&](const Reference& r) { return r.label == errors.reference; };
  LUEUR_CHECK_OP(std::ranges::count_if(comparison.references, same_label), ==, 1);
  for (const ErrorValue& error : errors.values) check_metric(comparison, error.metric);
  for (const ErrorMap& map : errors.maps) {
    check_metric(comparison, map.metric);
    check_image(comparison, map.image, 1);
    LUEUR_CHECK(map.full_scale > 0.0);
  }
}

void check(const Comparison& comparison) {
  check_image(comparison, comparison.direct, 3);
  for (const Reference& reference : comparison.references)
    check_pictures(comparison, reference.pictures);
  for (const Entry& entry : comparison.entries) {
    check_pictures(comparison, entry.pictures);
    for (const Errors& errors : entry.errors) check_errors(comparison, errors);
  }
}

// Three equal channels, of which the page's packing keeps one.
ImageF grey(const ImageF& image) {
  ImageF result(image.width, image.height, 3);
  for (size_t i = 0; i < result.samples.size(); ++i) result.samples[i] = image.samples[i / 3];
  return result;
}

// What the page shows: the results, and pictures by their number.
class PageData {
 public:
  explicit PageData(const Comparison& comparison)
      : title_(comparison.title), data_(results_json(comparison)) {
    data_["dropped_bits"] = kDroppedBits;
    for (size_t i = 0; i < comparison.references.size(); ++i) {
      const Reference& reference = comparison.references[i];
      data_["references"][i]["pictures"] = add(reference.pictures, reference.label);
    }
    for (size_t i = 0; i < comparison.entries.size(); ++i) {
      const Entry& entry = comparison.entries[i];
      data_["entries"][i]["pictures"] = add(entry.pictures, entry.label);
      data_["entries"][i]["maps"] = add_maps(entry);
    }
    data_["direct"] = add(comparison.direct, "direct light only");
  }

  Page page() && {
    return {.title = std::move(title_),
            .skeleton = kComparisonSkeleton,
            .styles = {kBaseStyle, kComparisonStyle},
            .scripts = {kComparisonScripts.begin(), kComparisonScripts.end()},
            .data = std::move(data_),
            .packed_pictures = std::move(pictures_)};
  }

 private:
  Json add(const ImageF& image, const std::string& name) {
    if (image.samples.empty()) return nullptr;
    PackedPicture packed = pack_picture(image);
    if (packed.replaced > 0)
      data_["warnings"].push_back(name + ": " + std::to_string(packed.replaced) +
                                  " samples are negative or not finite; NaN and negative ones are "
                                  "shown as 0");
    pictures_.push_back(std::move(packed.base64));
    return pictures_.size() - 1;
  }

  Json add(const Pictures& pictures, const std::string& label) {
    Json numbers = Json::object();
    numbers["composed"] = add(pictures.composed, label);
    numbers["indirect"] = add(pictures.indirect, label + ", indirect light");
    numbers["occlusion"] = add(grey(pictures.occlusion), label + ", occlusion");
    return numbers;
  }

  Json add_maps(const Entry& entry) {
    Json maps = Json::array();
    for (const Errors& errors : entry.errors) {
      for (const ErrorMap& map : errors.maps) {
        const std::string name = entry.label + ", " + map.metric + " against " + errors.reference;
        Json picture = add(map.image, name);
        if (picture.is_null()) continue;
        maps.push_back({{"reference", errors.reference},
                        {"metric", map.metric},
                        {"full_scale", map.full_scale},
                        {"picture", std::move(picture)}});
      }
    }
    return maps;
  }

  std::string title_;
  Json data_;
  std::vector<std::string> pictures_;
};

}  // namespace

Result<void> write_comparison(const Comparison& comparison, const std::filesystem::path& folder) {
  check(comparison);
  LUEUR_TRY_VOID(make_folder(folder));
  LUEUR_TRY_VOID(write_file(folder / "results.json", json_file(results_json(comparison))));
  LUEUR_TRY_VOID(write_file(folder / "results.csv", results_csv(comparison)));
  return write_file(folder / "index.html", page_html(PageData(comparison).page()));
}

}  // namespace lueur::report
