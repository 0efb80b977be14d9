// SPDX-License-Identifier: Apache-2.0
// The random walk through layers against adding and doubling, the shares of light that other code has converged to, and closed
// forms.
#include "harness/effects/layered_material/layer_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/effects/adding_doubling.h"
#include "tests/graph/layer_stacks.h"

namespace lamina {
namespace {

constexpr size_t paths = 8000;
constexpr size_t gauss_points = 24;

struct TestMedium {
  double albedo, depth, forward;
};

// A clear sheet over a base, `medium` between them, lit by 1 from all around.
Scene slab_over_base(const TestMedium& medium, float base) {
  Scene scene = stack_scene({{0, 0}, {base, 1}}, 1);
  auto& numbers = stack_of(scene).numbers;
  numbers["thickness"] = 4, numbers["scattering"] = 1;
  numbers["medium_depth"] = medium.depth, numbers["medium_albedo"] = medium.albedo, numbers["medium_g"] = medium.forward;
  return scene;
}

WalkedLight walked(const Scene& scene, glm::dvec3 to_eye = {0, 0, 1}, glm::dvec2 uv = {0.5, 0.5}, size_t count = paths,
                   uint64_t seed = 5) {
  return LayerWalk(scene, 0, Occluders(scene)).light({uv, {0, 0}, {0, 0}, to_eye}, count, seed);
}

// Within what chance allows, and that is little.
void expect_about(const WalkedLight& light, double expected, const std::string& what = "") {
  EXPECT_NEAR(light.mean.r, expected, 4.5 * light.deviation.r + 1e-4) << what;
  EXPECT_LT(light.deviation.r, 0.01) << "what there is to tell";
}

// Henyey and Greenstein's medium: shares of light along the normal, and of diffuse light, that come back and pass.
TEST(AddingDoubling, ComesToTheSharesOfTheTable) {
  const std::filesystem::path file = std::filesystem::path(LAMINA_DATA_DIR) / "slab_reflectance.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent: reference values are not part of the product";
  std::ifstream stream(file);
  size_t rows = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    double albedo = 0, depth = 0, forward = 0, back = 0, through = 0, diffuse_back = 0, diffuse_through = 0;
    numbers >> albedo >> depth >> forward >> back >> through >> diffuse_back >> diffuse_through;
    ASSERT_TRUE(numbers) << line;
    ++rows;
    if (forward > 0.8) continue;  // a lobe too narrow for so few directions
    const Cosines c = gauss_cosines(gauss_points, {1});
    const PlaneLayer slab = medium_layer(c, albedo, depth, forward);
    EXPECT_NEAR(sum_of_row(slab.back, gauss_points), back, 2e-4) << line;
    EXPECT_NEAR(sum_of_row(slab.through, gauss_points), through, 2e-4) << line;
    EXPECT_NEAR(diffuse_share(c, slab.back), diffuse_back, 2e-4) << line;
    EXPECT_NEAR(diffuse_share(c, slab.through), diffuse_through, 2e-4) << line;
    // Over a base: what the walk is asked for, from the table alone.
    for (const float base : {0.0f, 0.5f, 0.9f})
      if (depth <= 4)
        expect_about(walked(slab_over_base({albedo, depth, forward}, base), {0, 0, 1}, {0.5, 0.5}, 6000),
                     back + through * base * diffuse_through / (1 - base * diffuse_back), line);
  }
  EXPECT_GE(rows, 9u);
}

TEST(LayerWalk, SlabsSeenAtASlantShowWhatAddingAndDoublingGives) {
  const double slant = 0.4;
  const Cosines c = gauss_cosines(gauss_points, {1, slant});
  for (const TestMedium& medium : {TestMedium{0.9, 2, 0.75}, TestMedium{1, 1, 0}, TestMedium{0.6, 3, -0.4}}) {
    const PlaneLayer stack = over(medium_layer(c, medium.albedo, medium.depth, medium.forward), sheet_layer(c, 0.7, 0));
    const Scene scene = slab_over_base(medium, 0.7f);
    expect_about(walked(scene), sum_of_row(stack.back, gauss_points));
    expect_about(walked(scene, {std::sqrt(1 - slant * slant), 0, slant}), sum_of_row(stack.back, gauss_points + 1));
  }
}

// Three sheets with a medium in both gaps: layer 3 lies 3 texels below layer 2, which lies 4 below the surface.
TEST(LayerWalk, StacksOfSheetsInAMediumShowWhatAddingAndDoublingGives) {
  const Cosines c = gauss_cosines(gauss_points, {1});
  Scene scene = stack_scene({{0.8f, 0.3f}, {0.5f, 0.6f}, {0.9f, 1}}, 0);
  auto& numbers = stack_of(scene).numbers;
  numbers["thickness"] = 4, numbers["scattering"] = 0.5, numbers["layer_3_distance"] = 3;
  numbers["medium_depth"] = 6, numbers["medium_albedo"] = 0.95, numbers["medium_g"] = 0.6;
  // 6 mean free paths times 1/2 squared.
  const PlaneLayer lowest = over(medium_layer(c, 0.95, 1.5 * 3 / 4, 0.6), sheet_layer(c, 0.9, 0));
  const PlaneLayer middle = over(medium_layer(c, 0.95, 1.5, 0.6), over(sheet_layer(c, 0.5, 0.4), lowest));
  expect_about(walked(scene), sum_of_row(over(sheet_layer(c, 0.8, 0.7), middle).back, gauss_points));
}

// Light from one side, seen from all around at one slant: the mean is what adding gives for that pair of cosines.
TEST(LayerWalk, LightOfALampPassesAsPathsRunBothWays) {
  const double lamp = 0.6;
  const Cosines c = gauss_cosines(gauss_points, {lamp});
  const TestMedium medium{0.9, 1, 0.5};
  const PlaneLayer stack = over(medium_layer(c, medium.albedo, medium.depth, medium.forward), sheet_layer(c, 0.5, 0));
  Scene scene = slab_over_base(medium, 0.5f);
  scene.ambient = glm::vec3(0);
  scene.lights = {{"lamp", Light::Kind::directional, -glm::vec3(0.8f, 0, 0.6f), {}, glm::vec3(1)}};
  const LayerWalk walk(scene, 0, Occluders(scene));
  const size_t seen = gauss_points / 3;  // a cosine of the quadrature
  const double cosine = c.at[seen], sine = std::sqrt(1 - cosine * cosine);
  double sum = 0, variance = 0;
  constexpr int turns = 16;
  for (int i = 0; i < turns; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / turns;
    const WalkedLight light =
        walk.light({{0.5, 0.5}, {0, 0}, {0, 0}, {sine * std::cos(angle), sine * std::sin(angle), cosine}}, 4000, uint64_t(i));
    sum += light.mean.r / turns, variance += light.deviation.r * light.deviation.r / (turns * turns);
  }
  // Irradiance 0.6 on the surface, times the kernel between the two cosines.
  const double kernel = stack.back(gauss_points, seen) / (2 * cosine * c.weight[seen]);
  EXPECT_NEAR(sum, lamp * kernel, 4.5 * std::sqrt(variance) + 1e-4);
  EXPECT_LT(std::sqrt(variance), 0.002);
}

TEST(LayerWalk, SheetsWithoutAMediumShowAllBounces) {
  const std::vector<UniformLayer> printed = {{0.8f, 0.3f}, {0.6f, 0.4f}, {0.4f, 0.5f}, {0.9f, 1}};
  for (size_t n = 2; n <= 4; ++n) {
    std::vector<UniformLayer> stack(printed.begin(), printed.begin() + ptrdiff_t(n - 1));
    stack.push_back(printed[3]);
    for (const float shadowing : {0.0f, 1.0f}) expect_about(walked(stack_scene(stack, shadowing)), all_bounces(stack));
  }
}

// Where nothing is lost, all light comes back.
TEST(LayerWalk, AWhiteFurnaceIsWhite) {
  Scene scene = stack_scene({{1, 0.5f}, {1, 0.3f}, {1, 1}}, 1);
  auto& numbers = stack_of(scene).numbers;
  numbers["thickness"] = 3, numbers["medium_depth"] = 2, numbers["medium_albedo"] = 1, numbers["medium_g"] = 0.75;
  for (const glm::dvec3 to_eye : {glm::dvec3(0, 0, 1), glm::dvec3(0.98, 0, 0.199)})
    expect_about(walked(scene, to_eye, {0.5, 0.5}, 3000), 1);
}

// Without a medium, a texture below is where a straight ray meets it: as many texels beside as the sheet is deep, at 45
// degrees.
TEST(LayerWalk, AStraightRayMeetsTheTextureBelow) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 10;
  stack_of(scene).textures["inner_albedo"] =
      make_texture("half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(glm::vec3(x < 32 ? 1.0f : 0.0f), 1); }),
                   TexelMeaning::colour);
  const glm::dvec3 from_right = glm::normalize(glm::dvec3(1, 0, 1));
  // Seen from the right the ray goes to the left.
  expect_about(walked(scene, from_right, {40.0 / 64, 0.5}, 200), 1);
  expect_about(walked(scene, from_right, {44.0 / 64, 0.5}, 200), 0);
  expect_about(walked(scene, {0, 0, 1}, {30.0 / 64, 0.5}, 200), 1);
}

// A lamp's ray comes through the sheet above as far beside as that is high, and falls by Lambert's law of the layer's own
// normal.
TEST(LayerWalk, ALampsRayMeetsTheSheetAbove) {
  Scene scene = stack_scene({{0, 0}, {1, 1}}, 1);
  stack_of(scene).numbers["thickness"] = 10;
  stack_of(scene).textures["outer_albedo"] = make_texture(
      "half", filled(64, [](uint32_t x, uint32_t) { return glm::vec4(0, 0, 0, x < 40 ? 1 : 0); }), TexelMeaning::colour);
  scene.ambient = glm::vec3(0);
  scene.lights = {{"lamp", Light::Kind::directional, glm::normalize(glm::vec3(-1, 0, -1)), {}, glm::vec3(1)}};
  expect_about(walked(scene, {0, 0, 1}, {26.0 / 64, 0.5}, 200), std::sqrt(0.5));
  expect_about(walked(scene, {0, 0, 1}, {34.0 / 64, 0.5}, 200), 0);
  const glm::vec3 tilted = glm::normalize(glm::vec3(0.6f, 0, 0.8f));
  stack_of(scene).textures["inner_normal"] = make_texture(
      "tilted", filled(64, [&](uint32_t, uint32_t) { return glm::vec4(0.5f + 0.5f * tilted, 1); }), TexelMeaning::normal_mean);
  stack_of(scene).facts["inner_bend"] = 1;
  EXPECT_NEAR(walked(scene, {0, 0, 1}, {26.0 / 64, 0.5}, 200).mean.r, 1.4 * std::sqrt(0.5), 0.01);
}

// A mesh in the way hides a light that casts.
TEST(LayerWalk, AMeshInTheWayHidesALightThatCasts) {
  Scene scene = stack_scene({{0.8f, 1}, {0.5f, 1}}, 1);
  scene.ambient = glm::vec3(0);
  scene.lights = {{"lamp", Light::Kind::directional, glm::vec3(0, 0, -1), {}, glm::vec3(1)}};
  Object lid;
  lid.name = "lid";
  lid.mesh = unit_square();
  for (Vertex& vertex : lid.mesh.vertices) vertex.position.z = 1;
  scene.objects.push_back(lid);
  EXPECT_NEAR(walked(scene, {0, 0, 1}, {0.5, 0.5}, 200).mean.r, 0.8, 0.005);
  scene.lights[0].casts = true;
  expect_about(walked(scene, {0, 0, 1}, {0.5, 0.5}, 200), 0);
}

}  // namespace
}  // namespace lamina
