// SPDX-License-Identifier: MIT
#include "technique_list.h"

#include <gtest/gtest.h>

#include "lueur/hierarchical.h"

namespace lueur::cli {
namespace {

const HierarchicalSettings& settings_of(const ChosenTechnique& chosen) {
  return *static_cast<const HierarchicalSettings*>(chosen.technique->settings());
}

TEST(TechniqueList, EntriesInTheirOrder) {
  const auto list =
      choose_techniques("--techniques", "none,hierarchical:samples=8:start=full,hierarchical");
  ASSERT_TRUE(list.ok()) << list.error().message;
  ASSERT_EQ(list->size(), 3u);
  EXPECT_EQ((*list)[0].name(), "none");
  EXPECT_EQ((*list)[0].label, "none");
  EXPECT_EQ((*list)[0].technique, nullptr);
  EXPECT_EQ((*list)[1].name(), "hierarchical");
  EXPECT_EQ((*list)[1].label, "hierarchical:samples=8:start=full");
  EXPECT_EQ(settings_of((*list)[1]).samples, 8);
  EXPECT_EQ(settings_of((*list)[1]).start, HierarchicalSettings::Start::full);
  EXPECT_EQ((*list)[2].label, "hierarchical");
  EXPECT_EQ(settings_of((*list)[2]).samples, HierarchicalSettings{}.samples);
}

TEST(TechniqueList, ErrorsNameFlagAndEntry) {
  const std::pair<const char*, const char*> lists[] = {
      {"", "--techniques ''"},
      {"none,", "--techniques ''"},
      {"none,,hierarchical", "--techniques ''"},
      {"none,magic:samples=8", "--techniques 'magic:samples=8'"},
      {"hierarchical:", "--techniques 'hierarchical:': ''"},
      {"hierarchical:samples", "--techniques 'hierarchical:samples': 'samples'"},
      {"hierarchical:=8", "--techniques 'hierarchical:=8': '=8'"},
      {"none,hierarchical:samples=0", "--techniques 'hierarchical:samples=0': samples=0"},
      {"hierarchical:depth=1", "--techniques 'hierarchical:depth=1': depth"},
      {"hierarchical:preset=fast:depth=1",
       "--techniques 'hierarchical:preset=fast:depth=1': depth"},
      {"hierarchical:preset=slow", "--techniques 'hierarchical:preset=slow': preset 'slow'"},
      {"hierarchical:preset=", "--techniques 'hierarchical:preset=': preset ''"},
      {"hierarchical:samples=8:preset=fast",
       "--techniques 'hierarchical:samples=8:preset=fast': write the preset first"},
      {"none:preset=fast",
       "--techniques 'none:preset=fast': preset 'fast': the technique none has no presets"},
      {"none:samples=8", "--techniques 'none:samples=8': samples=8"},
      {"hierarchical,none,hierarchical", "--techniques 'hierarchical' is given twice"}};
  for (const auto& [text, part] : lists) {
    const auto list = choose_techniques("--techniques", text);
    ASSERT_FALSE(list.ok()) << text;
    EXPECT_EQ(list.error().kind, ErrorKind::usage) << text;
    EXPECT_TRUE(list.error().message.starts_with(part)) << list.error().message;
    EXPECT_EQ(list.error().message.find('\n'), std::string::npos) << list.error().message;
  }
}

TEST(TechniqueList, OneTechniqueByItsFlags) {
  const auto chosen = choose_technique("hierarchical", {"samples=8", "samples=16"});
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(settings_of(*chosen).samples, 16);
  EXPECT_EQ(chosen->label, "hierarchical:samples=8:samples=16");
  EXPECT_TRUE(choose_technique("magic", {}).error().message.starts_with("--technique 'magic'"));
  EXPECT_TRUE(choose_technique("none", {"a=1"}).error().message.starts_with("--set a=1"));
}

TEST(TechniqueList, SettingsGoOnTopOfAPreset) {
  const auto list = choose_techniques("--techniques", "hierarchical:preset=fast:samples=32");
  ASSERT_TRUE(list.ok()) << list.error().message;
  const HierarchicalSettings& listed = settings_of(list->front());
  EXPECT_EQ(list->front().label, "hierarchical:preset=fast:samples=32");
  EXPECT_EQ(listed.samples, 32);
  EXPECT_EQ(listed.start, HierarchicalSettings::Start::quarter);

  const auto flagged = choose_technique("hierarchical", {"samples=32"}, "fast");
  ASSERT_TRUE(flagged.ok()) << flagged.error().message;
  EXPECT_EQ(flagged->label, list->front().label);
  EXPECT_EQ(settings_of(*flagged).samples, 32);
  EXPECT_EQ(settings_of(*flagged).start, HierarchicalSettings::Start::quarter);
  EXPECT_TRUE(choose_technique("hierarchical", {}, "slow")
                  .error()
                  .message.starts_with("--preset 'slow': hierarchical has the presets "));
  EXPECT_TRUE(choose_technique("none", {}, "fast").error().message.starts_with("--preset 'fast'"));
}

TEST(TechniqueList, ACopyHasItsOwnSettings) {
  auto chosen = choose_technique("hierarchical", {"radius=7.5", "filter=false"});
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  ChosenTechnique other = copy(*chosen);
  EXPECT_EQ(settings_of(other).radius, 7.5f);
  EXPECT_FALSE(settings_of(other).filter);
  ASSERT_TRUE(change(other, "--scale", "radius=9").ok());
  EXPECT_EQ(settings_of(other).radius, 9.0f);
  EXPECT_EQ(settings_of(*chosen).radius, 7.5f);
  EXPECT_EQ(other.label, "hierarchical:radius=7.5:filter=false:radius=9");
  EXPECT_EQ(copy(ChosenTechnique{}).name(), "none");
}

}  // namespace
}  // namespace lueur::cli
