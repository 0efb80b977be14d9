// SPDX-License-Identifier: Apache-2.0
// The profile's closed forms against published and independently computed values, the truth against these forms, and the
// surface's own reflection against its tables.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/skin/diffusion.h"
#include "harness/effects/skin/layer_maps.h"
#include "harness/effects/skin/skin_baker.h"
#include "tests/effects/skin_scenes.h"

namespace lamina {
namespace {

void expect_close(glm::dvec3 found, glm::dvec3 right, double relative, const std::string& what) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c], right[c], relative * std::max(std::abs(right[c]), 1e-9)) << what << " " << c;
}

TEST(SkinProfile, IsTheTable) {
  const DiffusionProfile profile = default_profile();
  EXPECT_EQ(profile_problem(profile), "");
  expect_close(profile.value(0), {6.28552, 12.5906, 17.2725}, 5e-6, "beam");
  expect_close(profile.value(0.5), {.130301, .171742, .0870641}, 5e-6, "beam");
  expect_close(profile.value(1), {.0439081, .0127243, 8.50403e-4}, 5e-6, "beam");
  expect_close(profile.value(2), {.0126936, 1.7865e-4, 5.77341e-5}, 3e-5, "beam");
  expect_close(profile.inside_disc(0.5), {.428425, .863760, .968388}, 2e-6, "disc");
  expect_close(profile.inside_disc(2), {.806087, .998326, .999794}, 2e-6, "disc");
  expect_close(profile.line_of_light(0), {1.62466, 3.06578, 3.86393}, 2e-6, "line");
  expect_close(profile.line_of_light(1), {.121738, .0150372, .00155582}, 5e-6, "line");
  expect_close(profile.edge_of_light(0), {.5, .5, .5}, 1e-9, "edge");
  EXPECT_NEAR(profile.edge_of_light(0.5).r, .207122, 1e-6);
  EXPECT_NEAR(profile.edge_of_light(1).g, .003657, 1e-6);
  EXPECT_NEAR(profile.edge_of_light(2).b, .000028, 1e-6);
  EXPECT_NEAR(profile.transmitted(2).r, .194, 1e-3);
}

TEST(SkinProfile, LightOfASphereIsTheTable) {
  const DiffusionProfile profile = default_profile();
  const double cosines[] = {-.5, -.1, 0, .1, .5, 1}, red[] = {.006294, .040173, .067890, .134653, .478696, .945477},
               green[] = {1.8e-5, .001550, .016464, .101277, .498655, .997275},
               wide[] = {.000281, .012634, .035268, .111252, .493367, .986171};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(profile.sphere(cosines[i], 5).r, red[i], 2e-5) << cosines[i];
    EXPECT_NEAR(profile.sphere(cosines[i], 5).g, green[i], 2e-5) << cosines[i];
    EXPECT_NEAR(profile.sphere(cosines[i], 10).r, wide[i], 2e-5) << cosines[i];
  }
}

TEST(SkinProfile, WhatIsNoProfileIsSaid) {
  DiffusionProfile profile = default_profile();
  profile.weight[4].r = 0.2;
  EXPECT_NE(profile_problem(profile).find("the red weights of the profile sum to 0.842"), std::string::npos);
  profile = default_profile();
  profile.variance[2] = 0;
  EXPECT_NE(profile_problem(profile).find("Gaussian 3 of the profile has a width of 0"), std::string::npos);
}

// The mean over many seeds is exact to chance; one seed is what a pixel gets.
glm::dvec3 true_light(const SkinSurface& surface, glm::dvec3 position, glm::dvec3 normal, int seeds, size_t lines = 384) {
  glm::dvec3 sum(0);
  for (int i = 0; i < seeds; ++i) sum += diffused_light(surface, position, normal, lines, uint64_t(i) + 1).all;
  return sum / double(seeds);
}

TEST(SkinTruth, AnEdgeOfLightOnAPlateIsTheClosedForm) {
  const Scene scene = edge_of_light_scene();
  const Occluders occluders(scene);
  const SkinSurface surface(scene, occluders, 0);
  for (const double mm : {-3.0, -1.0, -0.3, 0.0, 0.2, 0.5, 1.0, 2.0, 5.0})
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(true_light(surface, {-mm / 1000, 0.001, 0}, {0, 0, 1}, 60)[c], surface.profile().edge_of_light(mm)[c], 0.004)
          << mm << " " << c;
}

TEST(SkinTruth, ConstantLightOnAPlateIsUnchanged) {
  std::vector<Object> objects;
  objects.push_back(skin_plate());
  const Scene scene = skin_scene(std::move(objects), {}, {0.25f, 0.5f, 1});
  const Occluders occluders(scene);
  const SkinSurface surface(scene, occluders, 0);
  expect_close(true_light(surface, {0.002, 0, 0}, {0, 0, 1}, 1, 96), {0.25, 0.5, 1}, 2e-3, "constant");
}

TEST(SkinTruth, ASphereIsTheClosedForm) {
  const glm::vec3 to_light(0, 0, 1);
  Object ball = skin_object("ball", globe_mesh(257, 129), glm::vec3(1), {{"skin.specular", 0}});
  ball.world_from_object = glm::mat4(0.005f);
  ball.world_from_object[3][3] = 1;
  std::vector<Object> objects;
  objects.push_back(std::move(ball));
  const Scene scene = skin_scene(std::move(objects), {directional_light("lamp", to_light, glm::vec3(1))}, glm::vec3(0));
  const Occluders occluders(scene);
  const SkinSurface surface(scene, occluders, 0);
  for (const double cosine : {-0.5, -0.1, 0.0, 0.1, 0.5, 0.9}) {
    const glm::dvec3 normal(std::sqrt(1 - cosine * cosine), 0, cosine);
    const glm::dvec3 light = true_light(surface, normal * 0.005, normal, 200), right = surface.profile().sphere(cosine, 5);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], right[c], 0.003) << cosine << " " << c;
  }
}

// What crosses a slab that is lit from behind is the profile's own sum, exp(-d^2 / 2v).
TEST(SkinTruth, LightCrossesAThinSheetByChords) {
  Object sheet = skin_plate();
  Mesh back = skin_square(-skin_plate_half_m, skin_plate_half_m, -skin_plate_half_m, skin_plate_half_m, -0.001f);
  for (Vertex& vertex : back.vertices) {
    vertex.normal = {0, 0, -1};
    sheet.mesh.vertices.push_back(vertex);
  }
  for (const uint32_t corner : {4u, 5u, 6u, 4u, 6u, 7u}) sheet.mesh.indices.push_back(corner);
  std::vector<Object> objects;
  objects.push_back(std::move(sheet));
  const Scene scene = skin_scene(std::move(objects), {directional_light("lamp", {0, 0, -1}, glm::vec3(1))}, glm::vec3(0));
  const Occluders occluders(scene);
  const SkinSurface surface(scene, occluders, 0);
  const glm::dvec3 light = true_light(surface, {0, 0, 0}, {0, 0, 1}, 20), right = surface.profile().transmitted(1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], right[c], 0.01) << c;
  EXPECT_EQ(diffused_light(surface, {0, 0, 0}, {0, 0, 1}, 96, 1).same_side, glm::dvec3(0));
}

TEST(SkinReflection, BeckmannIsTheTable) {
  const double cosines[] = {1, .99, .95, .9, .8};
  const double right[3][5] = {{25, 15.6657, 2.06105, .108189, 4.77e-5},
                              {11.1111, 9.23081, 4.10723, 1.24992, .0523669},
                              {1, 1.02010, 1.10201, 1.20548, 1.39107}};
  const double slopes[] = {.2, .3, 1};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(beckmann(cosines[k], slopes[i]), right[i][k], 6e-6 * right[i][k] + 5e-8);
}

TEST(SkinReflection, AlbedoIsTheTable) {
  const double degrees[] = {0, 45, 60, 75, 85};
  const double right[3][5] = {
      {.0845, .0948, .1725, .4779, 1.0035}, {.0801, .0899, .1478, .3712, .8163}, {.0325, .0458, .0687, .1535, .3695}};
  const double slopes[] = {.2, .3, 1};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(std::numbers::pi * reflected_share(std::cos(degrees[k] * std::numbers::pi / 180), slopes[i], 0.028),
                  right[i][k], 0.012 * right[i][k])
          << slopes[i] << " " << degrees[k];
  // A white surface reflects no more than comes, whatever enters it and comes back.
  const SurfaceReflection reflection(0.028);
  for (double cosine = 0; cosine <= 1; cosine += 0.05)
    for (double slope = 0.05; slope <= 1; slope += 0.05) {
      EXPECT_GE(reflection.share(cosine, slope), 0);
      EXPECT_LE(reflection.share(cosine, slope), 1);
    }
}

TEST(SkinReflection, MirrorPairsAreTheTable) {
  const double degrees[] = {0, 30, 60, 80}, right[] = {.077778, .089945, .324306, 6.439169};
  for (int k = 0; k < 4; ++k) {
    const double t = degrees[k] * std::numbers::pi / 180;
    EXPECT_NEAR(kelemen_reflection({0, 0, 1}, {std::sin(t), 0, std::cos(t)}, {-std::sin(t), 0, std::cos(t)}, 0.3, 0.028),
                right[k], 2e-5 * right[k]);
  }
  EXPECT_EQ(kelemen_reflection({0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, 0.3, 0.028), 0);
}

TEST(SkinBaker, ABallBendsByItsRadius) {
  const Mesh ball = globe_mesh(97, 49), flat = skin_square(0, 1, 0, 1, 0);
  const auto of_ball = mean_curvatures(ball), of_flat = mean_curvatures(flat);
  EXPECT_EQ(of_ball.size(), ball.vertices.size());
  EXPECT_EQ(of_flat.size(), flat.vertices.size());
  for (const float curvature : of_ball) EXPECT_NEAR(curvature, 1, 0.01);
  for (const float curvature : of_flat) EXPECT_EQ(curvature, 0);
}

TEST(SkinLayerMaps, SumToTheAlbedo) {
  EffectValues values;
  values.textures["skin_albedo"] = constant_texture("a", {0.61f, 0.37f, 0.27f, 1}, TexelMeaning::colour);
  const glm::vec3 albedo(base_texels(*values.textures["skin_albedo"]).rgba[0]),
      epidermal(base_texels(*epidermal_map(values)).rgba[0]), subdermal(base_texels(*subdermal_map(values)).rgba[0]);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(0.5f * albedo[c] + 0.3f * epidermal[c] + 0.2f * subdermal[c], albedo[c], 0.005f);
}

}  // namespace
}  // namespace lamina
