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
  const Outcome outcome = choose(square_model() + " --budget 4ms");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "nothing to choose");
}

// The cheapest cap within a loose limit is none of the exact ones; what it wrote is taken by compare. On a machine on which no
// timer is certified nothing is chosen, and that is said.
TEST_F(Choose, WhatItWritesCompareTakes) {
  const Outcome outcome = choose("open_plane --size 48x48 --min-ssim 0.5 --backend vulkan --truth-rays 0");
  if (outcome.output.find("certificate failed") != std::string::npos)
    GTEST_SKIP() << "no timer is certified on this machine now, so nothing is chosen";
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "chosen: ");
  EXPECT_SAYS(outcome.output, "that the search has not seen");
  EXPECT_SAYS(outcome.output, "the next 0.01 of SSIM");
  const std::string file = (out() / "configuration.toml").string();
  const Outcome taken = lamina_program("plan open_plane --configuration " + file);
  EXPECT_EQ(taken.status, 0) << taken.output;
}

TEST_F(Choose, NothingFitsIsSaidWithTheNearest) {
  const Outcome outcome = choose("open_plane --size 48x48 --budget 0.000001ms --backend vulkan --truth-rays 0");
  if (outcome.output.find("certificate failed") != std::string::npos)
    GTEST_SKIP() << "no timer is certified on this machine now, so nothing is chosen";
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "nothing fits; the nearest is");
  EXPECT_FALSE(std::filesystem::exists(out() / "configuration.toml"));
}

TEST_F(Choose, AConfigurationWithAVanishedVariantIsRefusedByAllThatTakeOne) {
  const std::string file = write("old.toml", "[configuration]\n[variants]\naperture_lighting = \"exact_ca\"\n").string();
  for (const std::string command : {"compare", "plan", "gate", "sweep"}) {
    const Outcome outcome = lamina_program(command + " open_plane --configuration " + file +
                                           (command == "sweep"  ? " --set scene.time=0:1:1"
                                            : command == "gate" ? " --against main"
                                                                : "") +
                                           (command == "plan" ? "" : " --out " + out().string()));
    EXPECT_EQ(outcome.status, 2) << command << ": " << outcome.output;
    EXPECT_SAYS(outcome.output, "old.toml:3");
    EXPECT_SAYS(outcome.output, "did you mean 'exact_cap'?");
  }
}

TEST_F(Choose, CalibrateRefusesRecordsThatTellNothing) {
  const Outcome compared =
      lamina_program("compare open_plane --size 32x32 --no-time --truth-rays 0 --backend vulkan --out " + out().string());
  ASSERT_EQ(compared.status, 0) << compared.output;
  const Outcome outcome = lamina_program("calibrate " + out().string() + " --cache " + (folder_ / "cache").string());
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_SAYS(outcome.output, "no frame that was timed");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cache"));
  EXPECT_EQ(lamina_program("calibrate " + (folder_ / "none").string()).status, 2);
}

}  // namespace
}  // namespace lamina
