// SPDX-License-Identifier: Apache-2.0
// The sun's path against the sky's geometry, and the light along it.
#include "harness/scene/made/day.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

float elevation_degrees(float time_s) { return glm::degrees(std::asin(daylight(time_s).to_sun.y)); }

// At 44 degrees north with the sun 16 degrees north of the equator it culminates at 90 - 44 + 16 degrees, in the south, and at
// midnight stands 90 - 44 - 16 degrees below the horizon, in the north.
TEST(Day, NoonAndMidnight) {
  EXPECT_NEAR(elevation_degrees(6.1f), 62.0f, 0.01f);
  EXPECT_GT(daylight(6.1f).to_sun.z, 0.0f);
  EXPECT_NEAR(elevation_degrees(6.1f + day_s / 2), -30.0f, 0.01f);
  EXPECT_LT(daylight(6.1f + day_s / 2).to_sun.z, 0.0f);
}

TEST(Day, StartsInTheMorningWithALowSunInTheEast) {
  EXPECT_NEAR(elevation_degrees(0), 10.0f, 1.0f);
  EXPECT_GT(elevation_degrees(0.1f), elevation_degrees(0));
  EXPECT_GT(daylight(0).to_sun.x, 0.9f);
}

TEST(Day, TheSunStandsStillAgainstTheSkysPole) {
  // The pole is 44 degrees above the north; the sun keeps 90 - 16 degrees from it all day.
  const glm::vec3 pole(0, std::sin(glm::radians(44.0f)), -std::cos(glm::radians(44.0f)));
  for (int i = 0; i < 240; ++i) {
    const glm::vec3 sun = daylight(0.1f * float(i)).to_sun;
    EXPECT_NEAR(glm::length(sun), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(sun, pole), std::sin(glm::radians(16.0f)), 1e-5f);
  }
}

TEST(Day, NoSunWhereItIsWhollyBelowTheHorizon) {
  int nights = 0;
  for (int i = 0; i < 480; ++i) {
    const float time = 0.05f * float(i);
    const Daylight day = daylight(time);
    if (elevation_degrees(time) <= -day_sun_radius_degrees) {
      EXPECT_EQ(day.radiance, glm::vec3(0)) << time;
      ++nights;
    } else if (elevation_degrees(time) > 0) {
      EXPECT_GT(day.radiance.r, 0.0f) << time;
    }
    EXPECT_GT(day.ambient.b, 0.0f) << "never wholly dark";
  }
  EXPECT_GT(nights, 100);
}

TEST(Day, WarmNearTheHorizonAndBluerAbove) {
  const auto warmth = [](float time) { return daylight(time).radiance.r / daylight(time).radiance.b; };
  EXPECT_GT(warmth(0), 1.2f);
  EXPECT_GT(warmth(-0.6f), warmth(0));
  EXPECT_LT(warmth(6.1f), 1.2f);
}

TEST(Day, NothingJumps) {
  constexpr float step = 0.01f;
  for (int i = 0; i < 2400; ++i) {
    const Daylight a = daylight(step * float(i)), b = daylight(step * float(i + 1));
    // The sky turns by 15 degrees a second; light comes and goes within half a second at the quickest.
    EXPECT_LT(glm::distance(a.to_sun, b.to_sun), 1.05f * glm::radians(15.0f) * step) << i;
    EXPECT_LT(glm::distance(a.radiance, b.radiance), 0.04f) << i;
    EXPECT_LT(glm::distance(a.ambient, b.ambient), 0.004f) << i;
    EXPECT_LT(glm::distance(a.background, b.background), 0.015f) << i;
  }
}

TEST(Day, Repeats) {
  for (const float time : {-3.5f, 0.0f, 7.25f}) {
    EXPECT_LT(glm::distance(daylight(time).to_sun, daylight(time + day_s).to_sun), 1e-4f);
    EXPECT_LT(glm::distance(daylight(time).radiance, daylight(time - 5 * day_s).radiance), 1e-3f);
  }
}

}  // namespace
}  // namespace lamina
