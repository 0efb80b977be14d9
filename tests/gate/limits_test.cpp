// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/limits.h"

#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/error.h"
#include "tests/folder.h"

namespace lamina {
namespace {

class GateLimits : public InFolder<> {
 protected:
  LimitsFile read(const std::string& text) {
    std::ofstream(file_) << text;
    return LimitsFile(file_, {{"layered_material"}, {"light_map", "vertex_normal"}, {"vulkan", "osmesa"}});
  }
  void expect_refused(const std::string& text, const std::string& words) {
    try {
      read(text);
      ADD_FAILURE() << "taken: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(file_.string() + ":"), std::string::npos) << "file and line: " << error.what();
    }
  }
  const std::filesystem::path file_ = folder_ / "limits.toml";
};

TEST_F(GateLimits, DefaultsThenLaterEntriesOverEarlierOnes) {
  const LimitsFile limits = read(R"(
[default]
max_slowdown = "3%"
min_ssim = 0.9
[[limit]]
variant = "vertex_normal"
min_ssim = 0.97
max_flip_to_truth = 0.2
times = "must_decide"
max_frame_ms = 12.5
[[limit]]
backend = "osmesa"
max_slowdown = 0.05
same_image = true
)");
  const Limits plain = limits.of("layered_material", "light_map", "vulkan");
  EXPECT_DOUBLE_EQ(plain.max_slowdown, 0.03);
  EXPECT_EQ(plain.baseline.min_ssim, 0.9);
  EXPECT_FALSE(plain.same_image);
  EXPECT_FALSE(plain.times_must_decide);
  EXPECT_FALSE(plain.max_frame_ms);
  const Limits both = limits.of("layered_material", "vertex_normal", "osmesa");
  EXPECT_DOUBLE_EQ(both.max_slowdown, 0.05);
  EXPECT_EQ(both.baseline.min_ssim, 0.97);
  EXPECT_EQ(both.truth.max_flip, 0.2);
  EXPECT_TRUE(both.same_image);
  EXPECT_TRUE(both.times_must_decide);
  EXPECT_EQ(both.max_frame_ms, 12.5);
  EXPECT_FALSE(both.baseline.max_flip);
}

TEST_F(GateLimits, UnknownNamesAreRefusedWithTheNearest) {
  expect_refused("[default]\nmax_slowdwon = 0.1\n", "did you mean 'max_slowdown'");
  expect_refused("[[limit]]\nvariant = \"vertex_norml\"\nmin_ssim = 0.9\n", "did you mean 'vertex_normal'");
  expect_refused("[[limit]]\nbackend = \"vulcan\"\nmin_ssim = 0.9\n", "did you mean 'vulkan'");
  expect_refused("[[limit]]\neffect = \"layered\"\nmin_ssim = 0.9\n", "layered_material");
  expect_refused("[defaults]\nmax_slowdown = 0.1\n", "did you mean 'default'");
}

TEST_F(GateLimits, ContradictionsAndValuesOutOfRangeAreRefused) {
  expect_refused("[[limit]]\nvariant = \"light_map\"\nmin_ssim = 0.9\n[[limit]]\nvariant = \"light_map\"\nmin_ssim = 0.8\n",
                 "keep one");
  expect_refused("[default]\nmin_ssim = 1.5\n", "min_ssim");
  expect_refused("[default]\nmax_flip = -0.1\n", "max_flip");
  expect_refused("[default]\nmax_slowdown = \"3 percent\"\n", "must be a percentage");
  expect_refused("[default]\nmax_slowdown = \"-3%\"\n", "between");
  expect_refused("[default]\nmax_slowdown = 0\n", "max_slowdown");
  expect_refused("[[limit]]\nmin_ssim = 0.9\n", "belong under [default]");
  expect_refused("max_slowdown = 0.1\n", "max_slowdown");
  expect_refused("[default]\ntimes = \"decide\"\n", "known: must_decide, may_stay_open");
  expect_refused("[default]\nmax_target_bytes = -1\n", "max_target_bytes");
  expect_refused("[default\n", "");
}

TEST_F(GateLimits, TheSameLimitTwiceIsNoContradiction) {
  EXPECT_NO_THROW(
      read("[[limit]]\nvariant = \"light_map\"\nmin_ssim = 0.9\n[[limit]]\nvariant = \"light_map\"\nmin_ssim = 0.9\n"));
  EXPECT_NO_THROW(
      read("[[limit]]\nvariant = \"light_map\"\nmin_ssim = 0.9\n[[limit]]\nbackend = \"osmesa\"\nmin_ssim = 0.8\n"));
}

}  // namespace
}  // namespace lamina
