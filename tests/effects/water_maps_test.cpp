// SPDX-License-Identifier: Apache-2.0
// What water makes for itself in a frame, against closed forms: a tile of waves by a Fourier transform, caustics by ratios of
// areas, the second picture of what lies below, and waves that objects throw back.
#include <gtest/gtest.h>

#include "harness/effects/water/waves.h"
#include "harness/scene/made/block_mesh.h"
#include "tests/effects/water_scenes.h"

namespace lamina {
namespace {

class WaterMaps : public EachBackend {
 protected:
  Image seen(const Scene& scene, std::string_view name) { return picture(scene, name, water_size); }

  // One more object, of one colour.
  static void add(Scene& scene, std::string name, Mesh mesh, glm::vec3 colour) {
    Object object;
    object.name = std::move(name);
    object.mesh = std::move(mesh);
    object.said.values = {{"albedo", {colour}}};
    Scene made = declared_scene({std::move(object)});
    scene.objects.push_back(std::move(made.objects[0]));
  }
};

// A square of sand below it, with lines of another colour: what refraction by waves bends.
void add_lines(Scene& scene, float depth_m) {
  for (int i = -4; i <= 4; ++i) {
    Object line;
    line.name = fmt::format("line_{}", i);
    line.mesh = water_rectangle({0.3f * float(i), -3}, {0.3f * float(i) + 0.1f, 3}, 3);
    line.world_from_object[3] = glm::vec4(0, 0.01f - depth_m, 0, 1);
    line.said.values = {{"albedo", {glm::vec3(0.7f, 0.1f, 0.05f)}}};
    Scene made = declared_scene({std::move(line)});
    scene.objects.push_back(std::move(made.objects[0]));
  }
}

// Three waves of whole numbers along a tile of four of the longest, 4 0, 3 4 and -5 12 of them: the transform is their sum.
TEST_P(WaterMaps, TheTransformIsTheSumOfItsWaves) {
  const double longest = 2.4, degrees = 180 / std::numbers::pi;
  Scene scene = still_pool(1.2, {{"wave_1_amplitude", 0.03},
                                 {"wave_1_length", longest},
                                 {"wave_1_direction", 0},
                                 {"wave_1_steepness", 0.2},
                                 {"wave_2_amplitude", 0.03},
                                 {"wave_2_length", longest * 4 / 5},
                                 {"wave_2_direction", degrees * std::atan2(4, 3)},
                                 {"wave_2_steepness", 0.15},
                                 {"wave_3_amplitude", 0.008},
                                 {"wave_3_length", longest * 4 / 13},
                                 {"wave_3_direction", degrees * std::atan2(12, -5)},
                                 {"wave_3_steepness", 0.1}});
  add_lines(scene, 1.2f);
  // The mesh fades waves that it cannot draw, the tile does not: a finer mesh draws all.
  scene.objects[0].mesh = water_rectangle({-6, -6}, {6, 6}, 0.12f);
  scene.effects.at("water").numbers.at("grid_spacing") = 0.12;
  scene.time_s = 1.7f;
  const Image sum = seen(scene, "full");
  EXPECT_GT(decibels(sum, seen(scene, "fft")), 50);
  EXPECT_LT(decibels(sum, seen(scene, "two_waves")), 40) << "each wave is seen";
}

// Under the crest of a sine, light is gathered 1 / (1 - d (n - 1) / n A k^2) times, where d is from the crest to the bottom.
TEST_P(WaterMaps, CrestsGatherLightAsTheyAreBent) {
  const double depth = 1.5, length = 4, k = 2 * std::numbers::pi / length, frequency = std::sqrt(9.81 * k);
  for (const double amplitude : {0.2, 0.4}) {
    const auto lit = [&](double caustics) {
      Scene scene = still_pool(depth, {{"wave_1_amplitude", amplitude},
                                       {"wave_1_length", length},
                                       {"wave_1_direction", 0},
                                       {"wave_1_steepness", 0},
                                       {"scattering", 0},
                                       {"caustics", caustics}});
      scene.objects[0].mesh = water_rectangle({-6, -6}, {6, 6}, 0.1f);
      scene.ambient = scene.background = glm::vec3(0);
      scene.lights[0].direction = {0, -1, 0};
      scene.time_s = static_cast<float>(std::numbers::pi / 2 / frequency);  // a crest stands over the middle
      return double(pixel(seen(scene, "area_caustics"), 24, 24).g);
    };
    const double gathered = 1 / (1 - (depth + amplitude) * (1.333 - 1) / 1.333 * amplitude * k * k);
    EXPECT_NEAR(lit(1) / lit(0), gathered, 0.03 * gathered) << amplitude;
  }
}

// A wall that stands on the bottom and reaches over the water hides the bottom behind it. A ray over its upper edge goes in
// steeply, and sees that bottom: the still water's light, as without a wall, and not what lies far behind.
TEST_P(WaterMaps, RaysThatBendSeeWhatIsHidden) {
  const Scene open = still_pool(1, {}, true);
  Scene scene = open;
  add(scene, "wall", block_mesh({{{-6, -1, -0.1f}, {6, -0.1f, 0}}}, 1), glm::vec3(0.05f, 0.6f, 0.05f));
  const Image right = seen(open, "full"), two = seen(scene, "full"), one = seen(scene, "one_layer");
  // Rows from the far water down to where the wall itself is seen.
  size_t as_open = 0, as_open_of_one = 0;
  for (int y = 2; y < 24; ++y) {
    const auto near = [&](const Image& image) { return glm::distance(pixel(image, 24, y), pixel(right, 24, y)) < 0.01f; };
    as_open += near(two), as_open_of_one += near(one);
  }
  EXPECT_GT(as_open, as_open_of_one + 3) << "the hidden bottom is seen in more rows";
  EXPECT_GE(as_open, 20u) << "all but a row or two at the wall's edge";
}

TEST_P(WaterMaps, OnlyWhatStandsInTheWaterThrowsWavesBack) {
  // Waves come head on, from the far side, so that the picture is its own mirror image.
  const auto scene_with = [&](double splashes, bool post) {
    Scene scene = still_pool(1,
                             {{"wave_1_amplitude", 0.03},
                              {"wave_1_length", 0.8},
                              {"wave_1_direction", -90},
                              {"splashes", splashes},
                              {"splash_size", 8}},
                             true);
    scene.time_s = 3;
    scene.lights[0].direction = glm::normalize(glm::vec3(0, -0.8f, 0.3f));
    const Block block{{-0.15f, -0.9f, -0.15f}, {0.15f, post ? 0.5f : -0.5f, 0.15f}};
    add(scene, post ? "post" : "stone", block_mesh({block}, 1), glm::vec3(0.4f, 0.3f, 0.2f));
    return scene;
  };
  EXPECT_GT(decibels(seen(scene_with(0, false), "full"), seen(scene_with(2, false), "full")), 70)
      << "under water it throws none";
  const Image none = seen(scene_with(0, true), "full"), some = seen(scene_with(2, true), "full");
  double changed = 0, unlike = 0;
  for (int y = 0; y < int(water_size); ++y)
    for (int x = 0; x < int(water_size); ++x) {
      const glm::vec3 change = pixel(some, x, y) - pixel(none, x, y),
                      off = pixel(some, x, y) - pixel(some, int(water_size) - 1 - x, y);
      changed += double(glm::dot(change, change)), unlike += double(glm::dot(off, off));
    }
  EXPECT_GT(changed, 0.05);
  EXPECT_LT(unlike, 0.2 * changed) << "as much to the left as to the right";
  // The map ends 2 m behind the post, where its waves have faded: the upper rows show what is further.
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < int(water_size); ++x)
      EXPECT_LT(glm::distance(pixel(none, x, y), pixel(some, x, y)), 1e-3f) << x << " " << y;
}

// Turbid water takes contrast from lines on the bottom, more of it the further they are; an even bottom stays as it is.
TEST_P(WaterMaps, TurbidWaterBlursWhatIsFar) {
  const auto pool_of = [](double scattering, bool lines) {
    Scene scene = still_pool(1.5, {{"scattering", scattering}});
    if (lines) add_lines(scene, 1.5f);
    return scene;
  };
  const auto contrast = [&](const Image& image) {
    float least = 1e9f, most = 0;
    for (int x = 12; x < 36; ++x) least = std::min(least, pixel(image, x, 24).g), most = std::max(most, pixel(image, x, 24).g);
    return double(most - least);
  };
  const Scene even = pool_of(8, false);
  EXPECT_GT(decibels(seen(even, "full"), seen(even, "blur_by_distance")), 50);
  const auto kept = [&](double scattering) {
    const Scene scene = pool_of(scattering, true);
    return contrast(seen(scene, "blur_by_distance")) / contrast(seen(scene, "full"));
  };
  const double clear = kept(1), turbid = kept(20);
  EXPECT_GT(clear, 0.85);
  EXPECT_LT(turbid, 0.6);
  EXPECT_GT(turbid, 0.01);
}

// Far from the world's middle a mesh that goes with the eye has short edges, and its points are the waves'.
TEST_P(WaterMaps, TheMeshGoesWithTheEye) {
  const auto worst_of = [&](double follows) {
    Scene scene = still_pool(2,
                             {{"wave_1_amplitude", 0.1},
                              {"wave_1_length", 8},
                              {"wave_1_steepness", 0.1},
                              {"grid_follows", follows},
                              {"grid_spacing", 0.5},
                              {"grid_growth", 0.1}},
                             true);
    scene.objects[0].mesh = water_disc(400, 0.5f, 0.1f);
    scene.views[0].eye += glm::vec3(60, 0, 20), scene.views[0].target += glm::vec3(60, 0, 20);
    const VariantManifest& baseline = variant("full");
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &baseline, .width = water_size, .height = water_size, .told = &baseline, .aspect = 1});
    const Image told = drawn.frame.targets_of(baseline).at("seen_ground");
    const GerstnerWaves waves(scene.effects.at("water"));
    double worst = 0;
    // The lower half shows water up to 5 m away.
    for (size_t i = told.rgba.size() / 2; i < told.rgba.size(); i += 4)
      if (told.rgba[i + 3] > 0)
        worst = std::max(worst, std::abs(waves.at({told.rgba[i], told.rgba[i + 1]}, 0).position.y - double(told.rgba[i + 2])));
    return worst;
  };
  const double followed = worst_of(1);
  EXPECT_LT(followed, 0.02);
  EXPECT_GT(worst_of(0), 3 * followed);
}

INSTANTIATE_TEST_SUITE_P(Backends, WaterMaps, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
