// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/configuration_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/error.h"

namespace lamina {
namespace {

class ConfigurationFile : public ::testing::Test {
 protected:
  ConfigurationFile() : library_(load_library(LAMINA_SOURCE_DIR, effect_code())) {
    Object object;
    object.name = "object";
    object.effects["layered_material"] = {{{"thickness", 8}}, {}, {}, {{"transparency", 1}}};
    scene_.objects = {object};
    plan_ = make_plan(library_, scene_);
  }
  std::filesystem::path file(const std::string& text) {
    const std::filesystem::path path = ::testing::TempDir() + "/configuration.toml";
    std::ofstream(path) << text;
    return path;
  }
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
  apply_configuration(plan_, file(configuration_text("a \"quoted\" scene.toml", {{"layered_material", "vertex_normal"}})));
  ASSERT_EQ(configuration_of(plan_, {}).size(), 1u);
  EXPECT_EQ(configuration_of(plan_, {}).front()->name, "vertex_normal") << "where another effect is compared";
  EXPECT_EQ(configuration_with(plan_, layers.baseline()).front(), &layers.baseline()) << "where this one is";
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
}

TEST_F(ConfigurationFile, EffectsThatAreNotCalledForMayBeNamed) {
  apply_configuration(plan_, file("[configuration]\n[variants]\nwater = \"schlick\"\n"));
  EXPECT_EQ(configuration_of(plan_, {}).size(), 1u);
}

}  // namespace
}  // namespace lamina
