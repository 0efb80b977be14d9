// SPDX-License-Identifier: Apache-2.0
// The truth of water against closed forms: still water over a level bottom; what each of its steps tells apart; pixels that an
// edge runs through; and caustics from afar.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "harness/effects/water/caustic_table.h"
#include "harness/effects/water/water_light.h"
#include "harness/effects/water/water_rays.h"
#include "harness/scene/made/block_mesh.h"
#include "tests/effects/water_scenes.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

constexpr float edge_slope = 0.02f, edge_depth = 1.5f;
constexpr glm::vec3 beyond_edge(0.02f, 0.03f, 0.04f);

// The bottom turns dark beyond a straight edge, x = edge_slope z: seen from straight above, it runs from row to row through
// other parts of the pixels.
Scene dark_beyond_an_edge() {
  Scene scene = still_pool(double(edge_depth));
  Object dark;
  dark.name = "dark";
  dark.mesh = water_rectangle({0, -60}, {60, 60}, 10);
  dark.world_from_object = glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {edge_slope, 0, 1, 0}, {0, 1e-3f - edge_depth, 0, 1});
  dark.said.values = {{"albedo", {beyond_edge}}};
  Scene made = declared_scene({std::move(dark)});
  scene.objects.push_back(std::move(made.objects[0]));
  return scene;
}

// The column of the picture, in pixels, through which the edge runs in a row's middle.
double column_of_edge(int row) {
  const double half = std::tan(15 * std::numbers::pi / 180), middle = water_size / 2.0,
               down = half * (row + 0.5 - middle) / middle;
  // Where a ray that leaves the eye by these tangents lands, beyond the edge.
  const auto beyond = [&](double right) {
    const double tangent = std::hypot(right, down), sine = tangent / std::hypot(tangent, 1) / 1.333,
                 out = tangent > 0 ? (4 * tangent + double(edge_depth) * sine / std::sqrt(1 - sine * sine)) / tangent : 0;
    return out * right - double(edge_slope) * out * down;
  };
  double low = -half, high = half;
  for (int i = 0; i < 60; ++i) (beyond((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return middle * (1 + low / half);
}

class WaterTruth : public EachBackend {
 protected:
  struct Answered {
    TruthAnswer answer;
    std::map<std::string, Image> told;
    glm::vec3 light(size_t step, int x, int y) const {
      const auto found = std::ranges::find(answer.pixels, size_t(y) * water_size + size_t(x));
      return found == answer.pixels.end() ? glm::vec3(NAN) : answer.steps.at(step).light[size_t(found - answer.pixels.begin())];
    }
  };

  // The truth by what the baseline told, which `changed` may change.
  Answered answered(const Scene& scene, size_t rays, const std::function<void(std::map<std::string, Image>&)>& changed = {}) {
    const VariantManifest& baseline = variant("full");
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &baseline, .width = water_size, .height = water_size, .told = &baseline, .aspect = 1});
    Answered made;
    made.told = drawn.frame.targets_of(baseline);
    if (changed) changed(made.told);
    DiskCache cache("");
    made.answer =
        water_rays({scene, drawn.bakes.occluders(), cache, rays})->answer({made.told, scene.views[0], {}}, [](double) {});
    return made;
  }
};

// All that the device finds in still water over a level bottom is right: every step is the closed form. What is put into one of
// its pictures shows in the steps before that picture is dropped, by as much as the surface lets through, and in no other.
TEST_P(WaterTruth, EachStepDropsOnePicture) {
  const Scene scene = still_pool(2);
  const double share = reflected_by_water(std::cos(angle_of(30, 20)), 1.333);
  const Answered plain = answered(scene, 1);
  ASSERT_EQ(plain.answer.steps.size(), 5u);
  for (size_t step = 0; step < 5; ++step)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(double(plain.light(step, 30, 20)[c]), still_light(2, angle_of(30, 20))[c], 1.5e-3) << step << " " << c;
  const size_t at = 4 * (20 * size_t(water_size) + 30);
  const glm::vec3 bottom(plain.told.at("seen_bottom").rgba[at], plain.told.at("seen_bottom").rgba[at + 1],
                         plain.told.at("seen_bottom").rgba[at + 2]),
      kept(plain.told.at("seen_kept").rgba[at], plain.told.at("seen_kept").rgba[at + 1],
           plain.told.at("seen_kept").rgba[at + 2]);
  struct Case {
    const char* target;
    size_t shows_in;  // the steps before this one
    glm::dvec3 by;
  };
  for (const Case& changed :
       {Case{"seen_mirrored", 1, glm::dvec3(0.1 * share)}, Case{"seen_bottom", 2, 0.1 * (1 - share) * glm::dvec3(kept)},
        Case{"seen_kept", 3, 0.1 * (1 - share) * glm::dvec3(bottom)},
        Case{"seen_scattered", 4, glm::dvec3(0.1 * (1 - share))}}) {
    const Answered other = answered(scene, 1, [&](std::map<std::string, Image>& told) {
      for (float& value : told.at(changed.target).rgba) value += 0.1f;
    });
    for (size_t step = 0; step < 5; ++step)
      for (int c = 0; c < 3; ++c) {
        // The extinction is dropped after the refraction: by then the light below is the rays'.
        const double by = step < changed.shows_in ? changed.by[c] : 0;
        EXPECT_NEAR(double(other.light(step, 30, 20)[c] - plain.light(step, 30, 20)[c]), by, 2e-4)
            << changed.target << " " << step << " " << c;
      }
  }
}

// Water that scatters nothing adds nothing, and takes what it absorbs; clear water takes nothing either.
TEST_P(WaterTruth, WhatWaterDoesNotDoHasNoStep) {
  const WaterNumbersSaid absorbs = waves_on({{"scattering", 0}});
  WaterNumbersSaid is_clear = absorbs;
  for (const char* channel : {"absorption_red", "absorption_green", "absorption_blue"}) is_clear[channel] = 0;
  const Answered absorber = answered(still_pool(2, absorbs), 1), clear = answered(still_pool(2, is_clear), 1);
  float most_taken = 0;
  for (size_t i = 0; i < absorber.answer.pixels.size(); ++i) {
    const auto light = [&](const Answered& of, size_t step) { return of.answer.steps[step].light[i]; };
    EXPECT_EQ(light(absorber, 4), light(absorber, 3)) << "nothing is scattered";
    EXPECT_LT(glm::distance(light(clear, 3), light(clear, 2)), 1e-6f) << "nothing is absorbed";
    most_taken = std::max(most_taken, glm::distance(light(absorber, 3), light(absorber, 2)));
  }
  EXPECT_GT(most_taken, 1e-6f) << "ways by waves are not quite those of the pictures";
  for (size_t i = 0; i < clear.told.at("seen_kept").rgba.size(); ++i) EXPECT_NEAR(clear.told.at("seen_kept").rgba[i], 1, 1e-6f);
}

// A pixel shows as much of what lies beyond an edge as the edge leaves of it: nine rays tell it to an eighteenth, for no two of
// them stand in one row or column.
TEST_P(WaterTruth, RaysShareOutAPixel) {
  const Answered edge = answered(dark_beyond_an_edge(), 9);
  double worst = 0;
  for (int row = 4; row < 44; ++row) {
    const double at = column_of_edge(row);
    const int column = static_cast<int>(std::floor(at));
    const double before = double(edge.light(4, column - 1, row).g), beyond = double(edge.light(4, column + 1, row).g);
    worst = std::max(worst, std::abs((double(edge.light(4, column, row).g) - beyond) / (before - beyond) - (at - column)));
  }
  EXPECT_LT(worst, 1.0 / 18 + 0.02);
}

// Where something stands before the water in a part of a pixel, the rest of it is told: a block stands in the water, under
// which the bottom ends. Rays through the block would see nothing there.
TEST_P(WaterTruth, WhatIsHiddenInAPixelIsNotTold) {
  Scene scene = still_pool(1);
  scene.objects[1].mesh = water_rectangle({-0.005f, -60}, {60, 60}, 10);
  Object block;
  block.name = "block";
  block.mesh = block_mesh({{{-3, -1, -3}, {-0.005f, 0.3f, 3}}}, 1);
  block.said.values = {{"albedo", {bottom_albedo}}};
  Scene made = declared_scene({std::move(block)});
  scene.objects.push_back(std::move(made.objects[0]));
  // The block stands to the left. Its edge at the water runs through pixels whose middles just show water.
  scene.views[0].eye.x = scene.views[0].target.x = 0.6f;
  const Answered beside = answered(scene, 16);
  int first = -1;
  for (int x = 0; x < int(water_size) && first < 0; ++x)
    if (std::isfinite(beside.light(4, x, 24).g)) first = x;
  ASSERT_GT(first, 0);
  ASSERT_LT(first, 20);
  // The block's own side is seen through the water next to it: no pixel there is darker than its neighbours by much.
  for (int y = 10; y < 38; ++y) EXPECT_GT(beside.light(4, first, y).g, 0.8f * beside.light(4, first + 1, y).g) << y;
}

// However far the pattern of caustics is, its mean is nearly the even light's: on the way to the smallest level the lesser of
// two patterns comes nearer to the mean of one. The table knows that mean at its texels alone; what is read between texels and
// between levels is up to 3% brighter.
TEST_P(WaterTruth, CausticsFromAfarAreEvenLight) {
  const auto mean_of = [&](double contrast, double size_m) {
    const Image image = picture(still_pool(1, {{"caustics", contrast}, {"caustic_size", size_m}}), "full", water_size);
    double sum = 0;
    for (int y = 12; y < 36; ++y)
      for (int x = 12; x < 36; ++x) sum += double(pixel(image, x, y).g) / (24 * 24);
    return sum;
  };
  const double even = mean_of(0, 1);
  for (const double size_m : {0.02, 0.1, 0.3}) EXPECT_NEAR(mean_of(1, size_m), even, 0.035 * even) << size_m;
}

TEST(WaterTables, EachLevelKnowsTheMeanOfTheLesser) {
  const TextureImage table = make_caustic_table();
  const auto half_at = [&](size_t level, size_t i) {
    uint16_t half = 0;
    std::memcpy(&half, &table.levels[level][2 * i], 2);
    return double(glm::unpackHalf1x16(half));
  };
  EXPECT_NEAR(half_at(0, 1), caustic_lesser_mean, 1e-3);
  EXPECT_NEAR(half_at(table.levels.size() - 1, 1), 1, 1e-3);
  // Every pair of texels of a level of 32 x 32. What is lost between texels brings it nearer to 1, in each level alike.
  const size_t level = 3, count = size_t{32} * 32;
  double sum = 0;
  for (size_t i = 0; i < count; ++i)
    for (size_t j = 0; j < count; ++j)
      sum += std::min(half_at(level, 2 * i), half_at(level, 2 * j)) / (double(count) * double(count));
  EXPECT_GT(half_at(level, 1), sum - 1e-3);
  EXPECT_LT(half_at(level, 1), sum + 0.03);
  EXPECT_LT(half_at(0, 1), half_at(level, 1));
}

INSTANTIATE_TEST_SUITE_P(Backends, WaterTruth, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
