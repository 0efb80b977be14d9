// SPDX-License-Identifier: Apache-2.0
// Rough glass against closed forms: how far each pyramid spreads a pixel, what an edge looks like through a rough pane, what
// lies before the glass, and the truth's rays.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/rough_refraction/glass_slab.h"
#include "harness/effects/rough_refraction/slab_rays.h"
#include "harness/truth/beckmann_facets.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/hair_scenes.h"

namespace lamina {
namespace {

constexpr float behind_m = 2, eye_m = 40;   // the wall behind the glass, the eye before it
constexpr double kept_share = 0.96 * 0.96;  // of light, by both faces of index 1.5 at right angles

// White squares before a black wall in the plane z = -2, in pixels of a picture that shows 1 m there; before them a pane at z =
// 0 whose rays spread over `spread_px` (standard deviation). Under ambient light of 1 alone: the pane itself shows 0.04 of it.
struct Square {
  float left, top, right, bottom;  // pixels
  float z = -behind_m;
};
Scene squares_behind_glass(const std::vector<Square>& squares, uint32_t size, double spread_px, double thickness_m = 0) {
  std::vector<Object> objects;
  const double spread_m = spread_px / size, slope = spread_m * std::numbers::sqrt2 / (0.5 * double(behind_m) + thickness_m / 3);
  Object pane;
  pane.name = "pane";
  pane.mesh = unit_square();
  pane.world_from_object[0][0] = pane.world_from_object[1][1] = 1.5f;
  pane.said.values = {{"rough_glass.roughness", {std::sqrt(slope)}},
                      {"rough_glass.thickness", {thickness_m}},
                      {"rough_glass.absorption_red", {0.0}},
                      {"rough_glass.absorption_green", {0.0}},
                      {"rough_glass.absorption_blue", {0.0}}};
  objects.push_back(std::move(pane));
  Object black;
  black.name = "black";
  black.mesh = unit_square();
  black.world_from_object = glm::mat4(3);
  black.world_from_object[3] = {0, 0, -behind_m - 0.002f, 1};
  black.said.values = {{"albedo", {glm::vec3(0)}}};
  objects.push_back(std::move(black));
  for (const Square& square : squares) {
    Object white;
    white.name = "white_" + std::to_string(objects.size());
    white.mesh = unit_square();
    const float scale = (eye_m - square.z) / (eye_m + behind_m) / static_cast<float>(size),
                half = 0.5f * static_cast<float>(size);
    white.world_from_object[0][0] = (square.right - square.left) * scale;
    white.world_from_object[1][1] = (square.bottom - square.top) * scale;
    white.world_from_object[3] = {((square.left + square.right) / 2 - half) * scale,
                                  (half - (square.top + square.bottom) / 2) * scale, square.z, 1};
    objects.push_back(std::move(white));
  }
  Scene scene = declared_scene(std::move(objects));
  View& view = scene.views[0];
  view.eye = {0, 0, eye_m}, view.target = {0, 0, 0};
  view.fov_y_degrees = glm::degrees(2 * std::atan(0.5f / (eye_m + behind_m)));
  view.near_m = 20, view.far_m = 60;
  return scene;
}

struct Blot {
  double energy = 0, spread_px = 0;  // the latter: standard deviation along an axis
};
// What a part of the picture holds above what the pane shows of itself, as a corner has it.
Blot blot(const Image& image, int left, int top, int side) {
  const double pane = double(image.rgba[0]);
  double sum = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x) {
      const double value = double(image.rgba[(size_t(y) * size_t(image.width) + size_t(x)) * 4]) - pane;
      sum += value, x1 += value * x, y1 += value * y, x2 += value * x * x, y2 += value * y * y;
    }
  x1 /= sum, y1 /= sum;
  return {sum, std::sqrt((x2 / sum - x1 * x1 + y2 / sum - y1 * y1) / 2)};
}

class RoughGlass : public EachBackend {};

// A pixel spreads as far as the level says, in the mean over where it lies among the level's texels, and no light is lost.
TEST_P(RoughGlass, PyramidsSpreadAPixelAsFarAsTheyMust) {
  struct Case {
    const char* variant;
    double rule;          // the level's spread is this times 2^level
    double spread_px[3];  // of levels 1 to 3
  };
  for (const auto& [name, rule, spreads] : {Case{"box_levels", .41, {.866, 1.66, 3.28}},
                                            {"thirteen_tap_levels", .865, {1.58, 3.39, 6.89}},
                                            {"dual_kawase", .97, {1.68, 3.76, 7.71}}})
    for (int level = 1; level <= 3; ++level) {
      constexpr int cell = 64, cells = 4, size = cell * cells;
      std::vector<Square> pixels;
      for (int i = 0; i < cells * cells; ++i) {
        const auto x = static_cast<float>(cell * (i % cells) + 28 + i % 8),
                   y = static_cast<float>(cell * (i / cells) + 28 + (i + i / 8) % 8);
        pixels.push_back({x, y, x + 1, y + 1});
      }
      const Image image = picture(squares_behind_glass(pixels, size, rule * std::exp2(level)), name, size);
      double variance = 0, energy = 0;
      for (int i = 0; i < cells * cells; ++i) {
        const Blot seen = blot(image, cell * (i % cells), cell * (i / cells), cell);
        variance += seen.spread_px * seen.spread_px / (cells * cells), energy += seen.energy / (cells * cells);
      }
      EXPECT_NEAR(std::sqrt(variance), spreads[level - 1], 0.012 * spreads[level - 1]) << name << " " << level;
      EXPECT_NEAR(energy, kept_share, 0.02) << name << " " << level;
    }
}

// An edge through the pane: Gauss' integral of how many spreads away it is.
TEST_P(RoughGlass, AnEdgeIsGaussian) {
  constexpr int size = 64;
  const double spread_px = 5;
  const Scene scene = squares_behind_glass({{-40, -40, 32, 104}}, size, spread_px);
  for (const auto& [name, error] : {std::pair("cone_samples", 0.03), {"thirteen_tap_levels", 0.05}, {"dual_kawase", 0.05}}) {
    const Image image = picture(scene, name, size);
    for (int x = 4; x < 60; ++x) {
      double mean = 0;
      for (int y = 20; y < 44; ++y) mean += (double(pixel(image, x, y).r) - 0.04) / 24;
      const double expected = kept_share * 0.5 * std::erfc((x + 0.5 - 32) / spread_px / std::numbers::sqrt2);
      EXPECT_NEAR(mean, expected, error) << name << " " << x;
    }
  }
}

// What stands before the glass is not seen through it.
TEST_P(RoughGlass, TheForegroundDoesNotBleed) {
  constexpr int size = 64;
  const Scene scene = squares_behind_glass({{20, -10, 26, 74, 1.0f}}, size, 6);  // white, before the pane
  const auto beside = [&](const char* name) {
    const Image image = picture(scene, name, size);
    return double(pixel(image, 30, 32).r - pixel(image, 63, 0).r);
  };
  EXPECT_NEAR(beside("cone_samples"), 0, 0.015) << "a linear look-up beside the edge";
  EXPECT_LT(beside("thirteen_tap_levels"), 0.015);
  EXPECT_LT(beside("box_levels"), 0.015);
  EXPECT_GT(beside("one_blur"), 0.04) << "the seed's has no depth";
}

TEST_P(RoughGlass, ClearGlassShowsThePictureAndMakesNoPyramid) {
  constexpr int size = 32;
  Scene scene = squares_behind_glass({{3, 5, 20, 27}}, size, 1);
  scene.objects[0].effects.at("rough_refraction").numbers["roughness"] = 0;
  const Plan plan = make_plan(library(), scene);
  for (const VariantManifest& candidate : library().effect("rough_refraction").variants) {
    const Image image = picture(scene, candidate.name, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double white = x >= 3 && x < 20 && y >= 5 && y < 27 ? 1 : 0;
        ASSERT_NEAR(double(pixel(image, x, y).r), 0.04 + kept_share * white, 2e-3) << candidate.name << " " << x << " " << y;
      }
  }
  ShaderCache shaders(backend_->info().api, library().shaders);
  for (const char* name : {"box_levels", "thirteen_tap_levels", "one_blur"}) {
    size_t passes = 0;
    for (const GraphPass& pass : make_graph(plan, configuration_with(plan, variant(name)), scene, shaders).passes)
      passes += !pass.draws.empty() && pass.pass->name == "down";
    EXPECT_LE(passes, 1u) << name;
  }
  scene.objects.erase(scene.objects.begin());
  EXPECT_FALSE(make_plan(library(), scene).of("rough_refraction")->called_for);
}

TruthAnswer true_glass(const Scene& scene, const Image& behind, size_t rays) {
  const std::map<std::string, Image> targets = {{"seen_behind", behind}};
  const Occluders occluders(scene);
  DiskCache cache("");
  return slab_rays({scene, occluders, cache, rays})->answer({targets, scene.views[0], {}}, [](double) {});
}

// The truth's two steps and the baseline see the same edge.
TEST_P(RoughGlass, TheBaselineIsTheTruthWhereItsAssumptionsHold) {
  constexpr int size = 48;
  const Scene scene = squares_behind_glass({{-40, -40, 24, 104}}, size, 4);
  Scene bare = scene;
  bare.objects.erase(bare.objects.begin());  // the pane
  const TruthAnswer answer = true_glass(scene, picture(bare, "lambert", size), 256);
  ASSERT_EQ(answer.pixels.size(), size_t(size * size));
  const Image image = picture(scene, "cone_samples", size);
  double squares = 0;
  for (size_t i = 0; i < answer.pixels.size(); ++i) {
    const int x = static_cast<int>(answer.pixels[i]) % size;
    const double expected = 0.04 + kept_share * 0.5 * std::erfc((x + 0.5 - 24) / 4 / std::numbers::sqrt2);
    for (const TruthStep& step : answer.steps) EXPECT_NEAR(double(step.light[i].r), expected, 0.03) << x;
    const double off = double(image.rgba[4 * answer.pixels[i]]) - double(answer.steps.back().light[i].r);
    squares += off * off / static_cast<double>(answer.pixels.size());
  }
  EXPECT_GT(-10 * std::log10(squares), 40);
}

// A clear slab moves what is behind it by d sin t (1 - cos t / (n cos t')), and does not turn it.
TEST(GlassSlabs, AClearSlabMovesRaysAndDoesNotTurnThem) {
  for (const double degrees : {0., 30., 60., 80.}) {
    const GlassSlab slab{0, 0.3, 1.5, glm::dvec3(0)};
    const double t = degrees * std::numbers::pi / 180, inside = std::sqrt(1 - std::sin(t) * std::sin(t) / 2.25);
    const glm::dvec3 normal(0, 0, 1), to_eye(std::sin(t), 0, std::cos(t));
    const auto ray = through(slab, glm::dvec3(0), normal, normal, to_eye);
    ASSERT_TRUE(ray);
    EXPECT_LT(glm::length(ray->direction + to_eye), 1e-12);
    const glm::dvec3 off = ray->from - glm::dot(ray->from, -to_eye) * -to_eye;
    EXPECT_NEAR(glm::length(off), 0.3 * std::sin(t) * (1 - std::cos(t) / (1.5 * inside)), 1e-12);
  }
  // A facet that is tilted by t turns a ray along the normal by asin(n sin(t - t')), sin t' = sin t / n.
  const GlassSlab slab{0, 0, 1.5, glm::dvec3(0)};
  const double t = 0.2, refracted = std::asin(std::sin(t) / 1.5);
  const auto ray = through(slab, glm::dvec3(0), {0, 0, 1}, {std::sin(t), 0, std::cos(t)}, {0, 0, 1});
  ASSERT_TRUE(ray);
  EXPECT_NEAR(std::asin(std::abs(ray->direction.x)), std::asin(1.5 * std::sin(t - refracted)), 1e-12);
}

TEST(BeckmannFacets, SpreadAsBeckmannSays) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
  double squares = 0;
  constexpr int side = 100;
  for (int i = 0; i < side * side; ++i) {
    const double cosine = glm::dot(beckmann_facet(0.3, normal, {(i % side + 0.5) / side, (i / side + 0.5) / side}), normal);
    squares += (1 / (cosine * cosine) - 1) / (side * side);  // of both axes
  }
  EXPECT_NEAR(squares, 0.3 * 0.3, 1e-3);
}

// Every variant of the built-in scene on two backends.
TEST(RoughGlassBackends, AgreeAndHaveNoNaN) {
  expect_backends_agree("rough_refraction", {load_scene("rough_glass", builtin_library())});
}

INSTANTIATE_TEST_SUITE_P(Backends, RoughGlass, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
