// SPDX-License-Identifier: Apache-2.0
// Glossy planes against closed forms: an edge that a rough floor reflects, a clear floor against a mirrored scene, what lies
// before the floor, and the truth's rays.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/effects/glossy_reflection/facet_rays.h"
#include "harness/scene/made/block_mesh.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/hair_scenes.h"

namespace lamina {
namespace {

constexpr float over_m = 2, above_m = 40;  // what is reflected over the floor, the eye above it
constexpr uint32_t floor_size = 48;

Object coloured_square(const std::string& name, const glm::mat4& place, glm::vec3 albedo) {
  Object object;
  object.name = name;
  object.mesh = unit_square();
  object.world_from_object = place;
  object.said.values = {{"albedo", {albedo}}};
  return object;
}
// A square of this side that faces up or down, a height above the floor.
glm::mat4 level_square(float side_m, float height_m, bool faces_up, float right_m = 0) {
  const float turned = faces_up ? -1.0f : 1.0f;
  return glm::mat4({side_m, 0, 0, 0}, {0, 0, turned * side_m, 0}, {0, -turned, 0, 0}, {right_m, height_m, 0, 1});
}
// A floor that reflects everything alike and has no light of its own.
Object mirror_floor(double roughness, float side_m = 1.5f) {
  Object floor = coloured_square("floor", level_square(side_m, 0, true), glm::vec3(0));
  floor.said.values["glossy.roughness"] = {roughness};
  floor.said.values["glossy.reflectance"] = {1.0};
  return floor;
}

// Seen straight from above: a white half plane over the floor, left of the picture's middle, before a black one. Both face
// down, so that the eye above sees through them. Under ambient light of 1 alone. A facet of slope s turns a ray by 2 s: rays
// spread over 2 s times the height, s^2 = roughness^4 / 2.
Scene edge_over_floor(double spread_px) {
  const double slope = spread_px / floor_size / (2 * double(over_m)) * std::numbers::sqrt2;
  std::vector<Object> objects;
  objects.push_back(mirror_floor(std::sqrt(slope)));
  objects.push_back(coloured_square("black", level_square(6, over_m + 0.002f, false), glm::vec3(0)));
  objects.push_back(coloured_square("white", level_square(4, over_m, false, -2), glm::vec3(1)));
  Scene scene = declared_scene(std::move(objects));
  View& view = scene.views[0];
  view.eye = {0, above_m, 0}, view.target = {0, 0, 0}, view.up = {0, 0, -1};
  view.fov_y_degrees = glm::degrees(2 * std::atan(0.5f / (above_m + over_m)));
  view.near_m = 20, view.far_m = 60;
  return scene;
}
double gaussian_edge(int column, double spread_px) {
  return 0.5 * std::erfc((column + 0.5 - floor_size / 2.0) / spread_px / std::numbers::sqrt2);
}

class GlossyFloor : public EachBackend {
 protected:
  // The truth's answer for what the baseline shows.
  TruthAnswer truth_of(const Scene& scene, size_t rays) {
    const VariantManifest& baseline = variant("facet_samples");
    DrawnFrame drawn(*backend_, library(), scene,
                     {.variant = &baseline, .width = floor_size, .height = floor_size, .told = &baseline, .aspect = 1});
    const auto targets = drawn.frame.targets_of(baseline);
    DiskCache cache("");
    return facet_rays({scene, drawn.bakes.occluders(), cache, rays})->answer({targets, scene.views[0], {}}, [](double) {});
  }
};

TEST_P(GlossyFloor, AnEdgeIsGaussian) {
  const double spread_px = 5;
  const Scene scene = edge_over_floor(spread_px);
  for (const auto& [name, error] : {std::pair("facet_samples", 0.03),
                                    {"thirteen_tap_mirror", 0.05},
                                    {"stretched_mirror", 0.05},
                                    {"dual_kawase_mirror", 0.05},
                                    {"box_mirror", 0.07}}) {
    const Image image = picture(scene, name, floor_size);
    for (int x = 4; x < 44; ++x) {
      double mean = 0;
      for (int y = 16; y < 32; ++y) mean += double(pixel(image, x, y).r) / 16;
      EXPECT_NEAR(mean, gaussian_edge(x, spread_px), error) << name << " " << x;
    }
  }
  // As it is, in the sharp picture.
  const Image sharp = picture(scene, "sharp_mirror", floor_size);
  for (int x = 0; x < int(floor_size); ++x) EXPECT_NEAR(double(pixel(sharp, x, 20).r), x < 24 ? 1 : 0, 1e-3) << x;
}

TEST_P(GlossyFloor, TheBaselineIsTheTruthBeforeAFlatWall) {
  const Scene scene = edge_over_floor(4);
  const TruthAnswer answer = truth_of(scene, 256);
  ASSERT_EQ(answer.pixels.size(), size_t(floor_size * floor_size));
  const Image image = picture(scene, "facet_samples", floor_size);
  double squares = 0;
  for (size_t i = 0; i < answer.pixels.size(); ++i) {
    const int x = static_cast<int>(answer.pixels[i] % floor_size);
    for (const TruthStep& step : answer.steps) EXPECT_NEAR(double(step.light[i].r), gaussian_edge(x, 4), 0.03) << x;
    const double off = double(image.rgba[4 * answer.pixels[i]]) - double(answer.steps.back().light[i].r);
    squares += off * off / static_cast<double>(answer.pixels.size());
  }
  EXPECT_GT(-10 * std::log10(squares), 40);
}

// Blocks over a floor, seen at a slant, in the light of a lamp. `mirrored`: what is there in place of the floor's reflection.
// Their red is 0 and the floor's, where it has a colour of its own, is not.
Scene blocks_over_floor(std::optional<double> roughness, bool mirrored) {
  std::vector<Object> objects;
  const auto add = [&](glm::vec3 low, glm::vec3 high, glm::vec3 albedo) {
    Object block;
    block.name = "block_" + std::to_string(objects.size());
    block.mesh = block_mesh({{low, high}}, 1);
    block.said.values = {{"albedo", {albedo}}};
    if (mirrored) {
      for (Vertex& vertex : block.mesh.vertices) vertex.position.y = -vertex.position.y, vertex.normal.y = -vertex.normal.y;
      for (size_t i = 0; i < block.mesh.indices.size(); i += 3) std::swap(block.mesh.indices[i], block.mesh.indices[i + 1]);
    }
    objects.push_back(std::move(block));
  };
  add({-0.8f, 0, -0.5f}, {-0.4f, 0.9f, -0.2f}, {0, 0.8f, 0.2f});
  add({0.0f, 0.3f, 0.1f}, {0.5f, 0.6f, 0.5f}, {0, 0.3f, 0.9f});
  add({0.3f, 0, -1.2f}, {0.9f, 1.2f, -0.9f}, {0, 0.9f, 0.9f});
  if (roughness) objects.push_back(mirror_floor(*roughness, 5));
  if (!roughness && !mirrored) objects.push_back(coloured_square("floor", level_square(5, 0, true), {1, 0, 0}));
  Scene scene = declared_scene(std::move(objects));
  Light lamp;
  lamp.name = "lamp";
  lamp.direction = glm::normalize(glm::vec3(0.4f, mirrored ? 0.7f : -0.7f, -0.5f));
  scene.lights = {lamp};
  scene.ambient = glm::vec3(0.2f);
  scene.background = {0, 0.1f, 0.2f};
  View& view = scene.views[0];
  view.eye = {0.3f, 1.1f, 2.8f}, view.target = {0, 0.1f, 0};
  view.fov_y_degrees = 40, view.near_m = 0.5f, view.far_m = 20;
  return scene;
}

TEST_P(GlossyFloor, AClearFloorShowsTheMirroredScene) {
  constexpr uint32_t size = 64;
  const Image mirrored = picture(blocks_over_floor(std::nullopt, true), "lambert", size),
              floor = picture(blocks_over_floor(std::nullopt, false), "lambert", size);
  const Scene scene = blocks_over_floor(0, false);
  const Plan plan = make_plan(library(), scene);
  ShaderCache shaders(backend_->info().api, library().shaders);
  for (const VariantManifest& candidate : library().effect("glossy_reflection").variants) {
    const Image image = picture(scene, candidate.name, size);
    size_t compared = 0, off = 0;
    for (int y = 0; y < int(size); ++y)
      for (int x = 0; x < int(size); ++x) {
        if (!(pixel(floor, x, y).r > 0.1f)) continue;
        ++compared;
        // The lamp's own highlight is red too; the scene's red is 0.
        const glm::vec3 difference = glm::abs(pixel(image, x, y) - pixel(image, x, y).r - pixel(mirrored, x, y));
        off += std::max(difference.g, difference.b) > 4e-3f;
      }
    EXPECT_GT(compared, 1500u);
    EXPECT_LE(off, compared / 100) << candidate.name << ": but for edges";
    size_t passes = 0;
    for (const GraphPass& pass : make_graph(plan, configuration_with(plan, candidate), scene, shaders).passes)
      passes += !pass.draws.empty() && pass.pass->name == "down";
    EXPECT_LE(passes, 1u) << candidate.name;
  }
  const Scene none = blocks_over_floor(std::nullopt, false);
  EXPECT_FALSE(make_plan(library(), none).of("glossy_reflection")->called_for);
}

// A post's reflection does not bleed into what is reflected beside and behind it.
TEST_P(GlossyFloor, WhatIsNearerDoesNotBleed) {
  constexpr uint32_t size = 64;
  const auto light_beside = [&](const char* name) {
    double light[2];
    for (const bool post : {false, true}) {
      std::vector<Object> objects;
      objects.push_back(mirror_floor(0.3, 8));
      if (post) {
        Object white;
        white.name = "post";
        white.mesh = block_mesh({{{-0.2f, 0.0f, 0.0f}, {0.2f, 2, 0.08f}}}, 1);
        white.said.values = {{"albedo", {glm::vec3(1)}}};
        objects.push_back(std::move(white));
      }
      Scene scene = declared_scene(std::move(objects));
      View& view = scene.views[0];
      view.eye = {0, 1, 4}, view.target = {0, 0, 0};
      view.fov_y_degrees = 30, view.near_m = 0.5f, view.far_m = 40;
      // Two pixels left of the post, three above its foot: the floor behind it, which reflects the black background.
      light[post] = double(pixel(picture(scene, name, size), 24, 29).r);
    }
    return light[1] - light[0];
  };
  EXPECT_NEAR(light_beside("facet_samples"), 0, 0.02) << "a linear look-up beside the edge";
  EXPECT_NEAR(light_beside("thirteen_tap_mirror"), 0, 0.01);
  EXPECT_GT(light_beside("one_blur_mirror"), 0.03) << "which has no depth";
}

// A white sheet just over the floor that faces down: the eye sees floor everywhere, the mirror's picture has the sheet. To the
// floor behind its edge the sheet is nearer than the floor itself, and no facet there reflects it, however coarse a level is
// asked.
TEST_P(GlossyFloor, LevelsLeaveOutWhatIsNearerThanTheFloor) {
  constexpr uint32_t size = 64;
  Scene scene = declared_scene({mirror_floor(0.3, 8), coloured_square("sheet", level_square(6, 0.05f, false), glm::vec3(1))});
  scene.objects[1].world_from_object[3].z = 2;  // from 1 m behind the middle to behind the eye
  View& view = scene.views[0];
  view.eye = {0, 1, 4}, view.target = {0, 0, 0};
  view.fov_y_degrees = 30, view.near_m = 0.5f, view.far_m = 40;
  // The sheet's edge, 5.1 m deep, stands at row 27.5; the floor there at 5.0 m, and 5.6 m four rows on.
  const auto behind_edge = [&](const char* name) {
    const Image image = picture(scene, name, size);
    EXPECT_GT(pixel(image, 32, 40).r, 0.9f) << name << ": the sheet is reflected";
    double most = 0;
    for (int y = 18; y < 24; ++y) most = std::max(most, double(pixel(image, 32, y).r));
    return most;
  };
  EXPECT_LT(behind_edge("facet_samples"), 0.02);
  for (const char* name : {"thirteen_tap_mirror", "box_mirror", "stretched_mirror"}) EXPECT_LT(behind_edge(name), 0.02) << name;
  EXPECT_GT(behind_edge("one_blur_mirror"), 0.1) << "which has no depth";
}

// Of a block only the face in the plane is a mirror: its sides reflect what is all around.
TEST_P(GlossyFloor, OnlyThePlaneIsAMirror) {
  Object table = mirror_floor(0.2);
  table.mesh = block_mesh({{{-1, -1, -1}, {1, 0, 1}}}, 1);
  table.world_from_object = glm::mat4(1);
  Scene scene = declared_scene({std::move(table)});
  scene.background = {1, 0, 0};
  scene.ambient = {0, 0.5f, 0};
  View& view = scene.views[0];
  view.eye = {0, 1, 5}, view.target = {0, -0.2f, 0};
  view.fov_y_degrees = 40, view.near_m = 1, view.far_m = 20;
  for (const VariantManifest& candidate : library().effect("glossy_reflection").variants) {
    const Image image = picture(scene, candidate.name, 32);
    const glm::vec3 top = pixel(image, 16, 14), side = pixel(image, 16, 22);
    EXPECT_NEAR(top.r, 1, 2e-3) << candidate.name;
    EXPECT_NEAR(top.g, 0, 2e-3);
    EXPECT_NEAR(side.r, 0, 2e-3) << candidate.name;
    EXPECT_NEAR(side.g, 0.5, 2e-3);
  }
}

// Every variant of the built-in scene on two backends.
TEST(GlossyBackends, AgreeAndHaveNoNaN) {
  expect_backends_agree("glossy_reflection", {load_scene("glossy_floor", builtin_library())});
}

INSTANTIATE_TEST_SUITE_P(Backends, GlossyFloor, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
