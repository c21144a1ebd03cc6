// SPDX-License-Identifier: MIT
#include "lueur/settings.h"

#include <gtest/gtest.h>

#include <set>

#include "lueur/hierarchical.h"

namespace lueur {
namespace {

TEST(Settings, TextGoesInAndComesBack) {
  HierarchicalSettings settings;
  const auto table = Hierarchical::settings_table();
  for (const auto& [name, text] : {std::pair{"start", "quarter"},
                                   {"levels", "7"},
                                   {"radius", "12.5"},
                                   {"filter", "false"},
                                   {"form_factor", "point"}}) {
    ASSERT_TRUE(set_from_text(table, &settings, name, text).ok()) << name;
    for (const SettingInfo& info : table) {
      if (info.name == name) {
        EXPECT_EQ(to_text(info, &settings), text);
      }
    }
  }
  EXPECT_EQ(settings.start, HierarchicalSettings::Start::quarter);
  EXPECT_EQ(settings.levels, 7);
  EXPECT_FLOAT_EQ(settings.radius, 12.5f);
}

TEST(Settings, WrongTextIsRefusedAndNamed) {
  HierarchicalSettings settings;
  const auto table = Hierarchical::settings_table();
  for (const auto& [name, text] : {std::pair{"levels", "0"},
                                   {"levels", "9"},
                                   {"levels", "2.5"},
                                   {"levels", ""},
                                   {"levels", "4x"},
                                   {"radius", "nan"},
                                   {"radius", "inf"},
                                   {"radius", "1e99"},
                                   {"start", "Half"},
                                   {"filter", "maybe"},
                                   {"nonsense", "1"}}) {
    const auto result = set_from_text(table, &settings, name, text);
    ASSERT_FALSE(result.ok()) << name << "=" << text;
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
    EXPECT_NE(result.error().message.find(name), std::string::npos);
  }
  EXPECT_EQ(settings.levels, HierarchicalSettings{}.levels);
}

TEST(Settings, EveryTableIsSound) {
  for (const TechniqueInfo& technique : techniques()) {
    const auto instance = technique.make();
    EXPECT_TRUE(check_ranges(technique.settings, instance->settings()).ok())
        << technique.name << " has a default out of range";
    std::set<std::string_view> names;
    for (const SettingInfo& info : technique.settings) {
      EXPECT_TRUE(names.insert(info.name).second) << "twice: " << info.name;
      EXPECT_LT(info.min, info.max);
      EXPECT_TRUE(info.summary.ends_with(".")) << info.name;
    }
  }
}

TEST(Presets, EveryOneOfEveryTechniqueIsInRange) {
  for (const TechniqueInfo& technique : techniques()) {
    std::set<std::string_view> names;
    for (const Preset& preset : technique.presets) {
      SCOPED_TRACE(std::string(technique.name) + " " + std::string(preset.name));
      EXPECT_TRUE(names.insert(preset.name).second);
      EXPECT_TRUE(preset.summary.ends_with("."));
      const auto instance = technique.make();
      const auto applied = apply_preset(technique, preset.name, instance->settings());
      ASSERT_TRUE(applied.ok()) << applied.error().message;
      EXPECT_TRUE(check_ranges(technique.settings, instance->settings()).ok());
      for (const auto& [name, text] : preset.settings)
        for (const SettingInfo& info : technique.settings)
          if (info.name == name) {
            EXPECT_EQ(to_text(info, instance->settings()), text) << name;
          }
    }
  }
}

TEST(Presets, DecideAllSettings) {
  const TechniqueInfo& technique = *find_technique("hierarchical");
  HierarchicalSettings settings;
  settings.radius = 7.0f;
  ASSERT_TRUE(apply_preset(technique, "fast", &settings).ok());
  EXPECT_EQ(settings.start, HierarchicalSettings::Start::quarter);
  EXPECT_EQ(settings.radius, HierarchicalSettings{}.radius);
  ASSERT_TRUE(apply_preset(technique, "balanced", &settings).ok());
  EXPECT_EQ(settings.start, HierarchicalSettings{}.start);

  const auto wrong = apply_preset(technique, "Fast", &settings);
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().kind, ErrorKind::usage);
  EXPECT_NE(wrong.error().message.find("fast, balanced"), std::string::npos);
}

}  // namespace
}  // namespace lueur
