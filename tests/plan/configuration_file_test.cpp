// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/configuration_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/core/error.h"
#include "tests/folder.h"

namespace lamina {
namespace {

class ConfigurationFile : public InFolder<> {
 protected:
  ConfigurationFile() : library_(load_library(LAMINA_SOURCE_DIR, effect_code())) {
    Object object;
    object.name = "object";
    object.effects["layered_material"] = {{{"thickness", 8}}, {}, {}, {{"transparency", 1}}};
    scene_.objects = {object};
    plan_ = make_plan(library_, scene_);
  }
  std::filesystem::path file(const std::string& text) { return write("configuration.toml", text); }
  std::string refusal(const std::string& text) {
    try {
      apply_configuration(plan_, file(text));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  Library library_;
  Scene scene_;
  Plan plan_;
};

TEST_F(ConfigurationFile, ComesBackAsItWasWritten) {
  const EffectManifest& layers = library_.effect("layered_material");
  EXPECT_EQ(configuration_of(plan_, {}).front(), &layers.baseline());
  const VariantManifest& vertex_normal = *layers.variant("vertex_normal");
  apply_configuration(plan_, file(configuration_text("a \"quoted\" scene.toml", library_, {&vertex_normal})));
  ASSERT_EQ(configuration_of(plan_, {}).size(), 1u);
  EXPECT_EQ(configuration_of(plan_, {}).front()->name, "vertex_normal") << "where another effect is compared";
  EXPECT_EQ(configuration_with(plan_, layers.baseline()).front(), &layers.baseline()) << "where this one is";
}

TEST_F(ConfigurationFile, ParametersComeBackToo) {
  const EffectManifest& layers = library_.effect("layered_material");
  const VariantManifest& declared = *layers.variant("half_map");
  const VariantManifest quarter = declared.with_defaults({{"map_scale", 0.25}});
  EXPECT_EQ(configuration_text("heart", library_, {&declared}).find("map_scale"), std::string::npos) << "a default";
  apply_configuration(plan_, file(configuration_text("heart", library_, {&quarter})));
  const VariantManifest& read = *configuration_of(plan_, {}).front();
  EXPECT_EQ(read.name, "half_map");
  EXPECT_EQ(read.parameter("map_scale")->value, 0.25);
  EXPECT_EQ(declared.parameter("map_scale")->value, 0.5);
}

TEST_F(ConfigurationFile, WhatIsWrongIsNamedWithItsLine) {
  const auto has = [&](const std::string& text, const std::string& words) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_NE(said.find("configuration.toml"), std::string::npos) << said;
  };
  has("[configuration]\n[variants]\nlayered_material = \"vertex_norma\"\n", "did you mean 'vertex_normal'?");
  has("[configuration]\n[variants]\nlayered_materia = \"vertex_normal\"\n", "did you mean 'layered_material'?");
  has("[configuration]\n[variants]\nlayered_material = 3\n", ":3");
  has("[configuration]\nscen = \"heart\"\n[variants]\n", "scen");
  has("[variants]\n", "configuration");
  has("variants = [", "");
  const std::string half_map = "[configuration]\n[variants]\nlayered_material = \"half_map\"\n[parameters]\n";
  has(half_map + "\"half_map.map_scal\" = 0.25\n", "did you mean 'map_scale'?");
  has(half_map + "\"half_map.map_scale\" = 2\n", ":5");
  has(half_map + "\"half_map.map_scale\" = 2\n", "from 0.0625 to 1");
  has(half_map + "\"half_map.map_scale\" = \"much\"\n", ":5");
  has(half_map + "\"vertex_normal.map_scale\" = 1\n",
      "'vertex_normal.map_scale' is no parameter of a variant under [variants]");
  has(half_map + "map_scale = 1\n", "write \"VARIANT.PARAMETER\"");
}

TEST_F(ConfigurationFile, EffectsThatAreNotCalledForMayBeNamed) {
  apply_configuration(plan_, file("[configuration]\n[variants]\nwater = \"schlick\"\n"));
  EXPECT_EQ(configuration_of(plan_, {}).size(), 1u);
}

}  // namespace
}  // namespace lamina
