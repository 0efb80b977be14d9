// SPDX-License-Identifier: Apache-2.0
// lamina choose, calibrate and --configuration from end to end.
#include "tests/cli/program.h"

namespace lamina {
namespace {

class Choose : public ProgramTest {
 protected:
  Outcome choose(const std::string& arguments) {
    return lamina_program("choose " + arguments + " --cache \"\" --out " + out().string());
  }
};

TEST_F(Choose, WhatIsMissingOrCannotBeIsNamed) {
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = choose(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_SAYS(outcome.output, words);
    EXPECT_FALSE(std::filesystem::exists(out() / "configuration.toml")) << arguments;
  };
  refused("open_plane", "--budget");
  refused("open_plane --budget 4parsec", "4parsec");
  refused("open_plane --budget -3ms", "-3ms");
  refused("open_plane --min-ssim 2", "min-ssim");
  refused("open_plane --limit beauty=1", "beauty");
  refused("open_plane --budget 4ms --to nowhere", "nowhere");
  refused("heart_in_fo --budget 4ms", "heart_in_fo");
  refused("fog_heart --budget 4ms --to truth", "truth");
  refused("open_plane --budget 4ms --backend vulkan --backend osmesa", "takes one");
}

TEST_F(Choose, ASceneThatCallsForNothingHasAnEmptyAnswer) {
  square_model();
  const auto plain = write("plain.toml", "[scene]\nmodel = \"square.gltf\"\n[objects.\"*\"]\nlayers = false\n");
  const Outcome outcome = choose(plain.string() + " --budget 4ms");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "nothing to choose");
}

TEST_F(Choose, AConfigurationWithAVanishedVariantIsRefusedByAllThatTakeOne) {
  const std::string file = write("old.toml", "[configuration]\n[variants]\naperture_lighting = \"exact_ca\"\n").string();
  for (const std::string command : {"compare", "plan", "gate", "sweep"}) {
    const Outcome outcome = lamina_program(command + " open_plane --configuration " + file +
                                           (command == "sweep"  ? " --set scene.time=0:1:1"
                                            : command == "gate" ? " --against " LAMINA_SOURCE_DIR
                                                                : "") +
                                           (command == "plan" ? "" : " --out " + out().string()));
    EXPECT_EQ(outcome.status, 2) << command << ": " << outcome.output;
    EXPECT_SAYS(outcome.output, "old.toml:3");
    EXPECT_SAYS(outcome.output, "did you mean 'exact_cap'?");
  }
}

TEST_F(Choose, CalibrateRefusesRecordsThatTellNothing) {
  const Outcome compared =
      lamina_program("compare " + square_model() +
                     " --size 32x32 --no-time --truth-rays 0 --backend vulkan --variant vertex_normal --out " + out().string());
  ASSERT_EQ(compared.status, 0) << compared.output;
  const Outcome outcome = lamina_program("calibrate " + out().string() + " --cache " + (folder_ / "cache").string());
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_SAYS(outcome.output, "no frame that was timed");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cache"));
  EXPECT_EQ(lamina_program("calibrate " + (folder_ / "none").string()).status, 2);
}

}  // namespace
}  // namespace lamina
