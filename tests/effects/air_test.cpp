// SPDX-License-Identifier: Apache-2.0
// The truth of the atmosphere against closed forms, and against figures that were computed by another program.
#include "harness/effects/atmosphere/air.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/atmosphere/single_scattering.h"
#include "harness/effects/atmosphere/single_scattering_truth.h"
#include "harness/graph/views.h"
#include "harness/truth/view_rays.h"
#include "tests/effects/air_scenes.h"

namespace lamina {
namespace {

// Figures are given to six decimals or digits.
void expect_figure(double value, double figure) { EXPECT_NEAR(value, figure, std::max(1e-4 * figure, 6e-7)); }
void expect_figures(glm::dvec3 value, glm::dvec3 figure) {
  for (int c = 0; c < 3; ++c) expect_figure(value[c], figure[c]);
}

Air earth() { return {}; }
Air without_ozone() {
  Air air;
  air.ozone = glm::dvec3(0);
  return air;
}
Air molecules_only() {
  Air air = without_ozone();
  air.mie = glm::dvec3(0);
  return air;
}
glm::dvec3 from_ground(const Air& air, double zenith_degrees) {
  return sun_transmittance(air, {0, 0, 0}, direction_at(zenith_degrees, 0));
}

TEST(Air, LetsThroughWhatIsKnownOfTheEarths) {
  const struct {
    double zenith_degrees;
    glm::dvec3 share;
  } known[] = {{0, {.940359, .867616, .762310}},  {60, {.884784, .753858, .582282}}, {80, {.712941, .459379, .221627}},
               {85, {.543645, .249468, .063628}}, {88, {.330809, .085276, .006158}}, {90, {.106429, .009580, .000052}}};
  for (const auto& [zenith, share] : known) expect_figures(from_ground(earth(), zenith), share);
  expect_figures(from_ground(without_ozone(), 0), {.949572, .892444, .763283});
  expect_figures(from_ground(without_ozone(), 90), {.119170, .013288, .000053});
}

TEST(Air, PathsAreLongerTowardsTheHorizonAsIsKnown) {
  const Air air = molecules_only();
  const double straight_up = -std::log(from_ground(air, 0).g);
  expect_figure(straight_up, .108463596);
  for (const auto& [zenith, ratio] :
       {std::pair{60.0, 1.99256}, {80.0, 5.55020}, {85.0, 10.13833}, {88.0, 18.65844}, {90.0, 35.35490}})
    expect_figure(-std::log(from_ground(air, zenith).g) / straight_up, ratio);
}

// Straight up and down both rays and sunlight have closed forms (forms of Bruneton's tests of his functions).
TEST(Air, ScattersStraightUpAndDownByClosedForms) {
  const Air air = molecules_only();
  const glm::dvec3 up(0, 1, 0);
  const double tau = -std::log(from_ground(air, 0).g), along = 3 / (8 * std::numbers::pi);
  expect_figure(single_scattering(air, {{0, 0, 0}, up}, INFINITY, true, up).radiance.g / along, tau * std::exp(-tau));
  expect_figure(single_scattering(air, {{0, 0, 0}, up}, INFINITY, true, up).radiance.g / along, .097314792);
  const Scattered down = single_scattering(air, {{0, 150e3, 0}, -up}, INFINITY, true, up);
  expect_figure(down.radiance.g / along, (1 - std::exp(-2 * tau)) / 2);
  expect_figure(down.radiance.g / along, .097505711);
  expect_figure(down.transmittance.g, std::exp(-tau));
}

TEST(Air, ScattersOnceWhatIsKnownOfTheEarths) {
  const struct {
    double view_degrees, sun_degrees, azimuth_degrees;
    glm::dvec3 light;
  } known[] = {{0, 60, 0, {.003311, .006617, .013327}},    {45, 60, 0, {.012748, .018891, .031214}},
               {45, 60, 180, {.003814, .007666, .015064}}, {80, 60, 0, {.036532, .052467, .069072}},
               {89, 85, 0, {.319433, .140622, .029480}},   {0, 85, 0, {.002025, .002939, .004526}}};
  for (const auto& [view, sun, azimuth, light] : known)
    expect_figures(
        single_scattering(earth(), {{0, 0, 0}, direction_at(view, 0)}, INFINITY, true, direction_at(sun, azimuth)).radiance,
        light);
}

// A thin layer close to the ground on a planet without haze or curvature to speak of: a homogeneous slab. Figures: L / (p E).
TEST(Air, ScattersInASlabByItsClosedForm) {
  Air air = molecules_only();
  air.planet_radius_m = 1e12, air.rayleigh_height_m = 1e9, air.top_m = 1000, air.rayleigh = glm::dvec3(0.16 / 1000);
  const struct {
    double view, sun, light;  // cosines
  } known[] = {{1, 1, .136343006},  {1, .2, .100703706},  {.5, .5, .232367692},
               {.1, 1, .722496968}, {.1, .2, .494864892}, {.01, .5, .740968290}};
  for (const auto& [view, sun, light] : known) {
    const glm::dvec3 along(std::sqrt(1 - view * view), view, 0), to_sun(std::sqrt(1 - sun * sun), sun, 0);
    const double cosine = glm::dot(along, to_sun), phase = 3 / (16 * std::numbers::pi) * (1 + cosine * cosine);
    expect_figure(single_scattering(air, {{0, 0, 0}, along}, INFINITY, true, to_sun).radiance.g / phase, light);
  }
}

TEST(Air, AltitudeKeepsItsDigitsNearTheGround) {
  for (const double height : {1e-3, 0.5, 2.0, 1e4, 1e6})
    EXPECT_NEAR(altitude_m(earth(), {0, height, 0}), height, 1e-9 * height);
  // A level ray rises by s^2 / 2R.
  EXPECT_NEAR(altitude_m(earth(), {50e3, 0, 0}), 50e3 * 50e3 / (2 * 6360e3), 0.02);
  EXPECT_EQ(altitude_m(earth(), {0, -30, 0}), 0) << "below the sea";
}

TEST(Air, TheSunIsGoneWhereThePlanetIsInItsWay) {
  const Air air = earth();
  EXPECT_EQ(from_ground(air, 90.01), glm::dvec3(0));
  EXPECT_GT(sun_transmittance(air, {0, 20e3, 0}, direction_at(92, 0)).r, 0.05) << "but high up it shines still";
  const auto zenith_sky = [&](double sun) {
    return single_scattering(air, {{0, 2, 0}, {0, 1, 0}}, INFINITY, true, direction_at(sun, 0)).radiance;
  };
  EXPECT_GT(zenith_sky(94).b, 1e-5);
  EXPECT_LT(zenith_sky(97).b, zenith_sky(94).b / 10);
  EXPECT_EQ(zenith_sky(110), glm::dvec3(0)) << "all of the air is in the shadow";
}

TEST(Air, NoneAboveItsTop) {
  const Air air = earth();
  const Scattered away = single_scattering(air, {{0, 200e3, 0}, {0, 1, 0}}, INFINITY, true, {0, 1, 0});
  EXPECT_EQ(away.radiance, glm::dvec3(0));
  EXPECT_EQ(away.transmittance, glm::dvec3(1));
  const Scattered limb = single_scattering(air, {{0, 200e3, 0}, direction_at(103.5, 0)}, INFINITY, true, direction_at(20, 0));
  EXPECT_GT(limb.radiance.b, 0) << "a ray from space may pass through it";
}

TEST(Air, RaysOfPixelsAreThoseOfTheirMatrices) {
  View view;
  view.eye = {3, 700, -20}, view.target = {-40, 650, -900}, view.fov_y_degrees = 37, view.far_m = 5000;
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(eye_view(view, 64, 48).clip_from_world()));
  for (const auto& [column, row] : {std::pair{0, 0}, {63, 0}, {10, 40}, {63, 47}}) {
    const glm::dvec4 far = world_from_clip * glm::dvec4(2 * (column + 0.5) / 64 - 1, 2 * (row + 0.5) / 48 - 1, 1, 1);
    const glm::dvec3 through = glm::normalize(glm::dvec3(far) / far.w - glm::dvec3(view.eye));
    EXPECT_LT(glm::distance(ViewRays(view, 64, 48).direction(column, row), through), 1e-5);
  }
}

TEST(Air, NumbersOfTheSceneAreTheEarthsWhereItGivesNone) {
  Scene scene;
  add_air(scene);
  const Air air = air_of(scene.effects.at("atmosphere")), known = earth();
  EXPECT_EQ(air.planet_radius_m, known.planet_radius_m);
  EXPECT_EQ(air.top_m, known.top_m);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(air.rayleigh[c], known.rayleigh[c], 1e-12);
    EXPECT_NEAR(air.mie[c], known.mie[c], 1e-12);
    EXPECT_NEAR(air.ozone[c], known.ozone[c], 1e-13);
  }
  EXPECT_NEAR(air.mie_albedo, known.mie_albedo, 1e-9);
  EXPECT_NEAR(air.mie_g, known.mie_g, 1e-9);
  EXPECT_EQ(air.mie_height_m, known.mie_height_m);
  add_air(scene, {{"density", 2}, {"mie_amount", 3}, {"ozone_amount", 0}});
  const Air thick = air_of(scene.effects.at("atmosphere"));
  EXPECT_NEAR(thick.rayleigh.g, 2 * air.rayleigh.g, 1e-12);
  EXPECT_NEAR(thick.mie.g, 6 * air.mie.g, 1e-12);
  EXPECT_EQ(thick.ozone, glm::dvec3(0));
  add_air(scene, {{"density", 2}, {"ozone_amount", 3}, {"mie_amount", 1}});
  EXPECT_NEAR(air_of(scene.effects.at("atmosphere")).ozone.g, 6 * air.ozone.g, 1e-13);
}

}  // namespace
}  // namespace lamina
