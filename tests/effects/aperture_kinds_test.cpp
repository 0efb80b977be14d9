// SPDX-License-Identifier: Apache-2.0
// Apertures with an edge that fades, and those that are open or blocked by which errs less: closed forms, and what each backend
// draws of them.
#include <gtest/gtest.h>

#include "harness/effects/aperture_lighting/direct_light.h"
#include "harness/effects/cap_intersection/cap_area.h"
#include "harness/scene/textures.h"
#include "tests/effects/made_scenes.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

constexpr ApertureKind soft{.soft = true}, choice{.count = 2, .choice = true};

std::vector<Aperture> first_of(const Scene& scene, ApertureKind kind) {
  Bakes bakes(scene, effect_code(), DiskCache(""));
  std::vector<Aperture> all = vertex_apertures(bakes, 0, kind);
  all.resize(kind.count);
  return all;
}
double edge_of(const Aperture& aperture) { return 1 / double(glm::length(glm::vec3(aperture))) - 1; }

Object wall() { return quad("wall", {-0.01f, -500, -500}, {-0.01f, 500, -500}, {-0.01f, 500, 500}, {-0.01f, -500, 500}); }
Object hole(float radius) { return ring("lid", std::tan(radius), 1, 500, 1); }
Object disc(float radius) { return ring("disc", 0, 1, std::tan(radius), 1); }

// A share that falls linearly in the cosine over 2 w around c, summed over the hemisphere.
TEST(SoftApertures, TheEdgeIsThatOfALinearRamp) {
  const std::vector<SurfacePoint> point = {{{0, 0, 0}, {0, 1, 0}}};
  const Visibility visibility(point, 10000, 1);
  for (const auto& [c, w] : {std::pair(0.5, 0.3), {0.4, 0.1}, {0.7, 0.25}}) {
    double share = 0, along = 0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double z = (i + 0.5) / steps, seen = std::clamp((z - c) / (2 * w) + 0.5, 0.0, 1.0);
      share += seen / steps, along += seen * z / steps;
    }
    EXPECT_NEAR(share, 1 - c, 1e-4);
    EXPECT_NEAR(edge_angle(visibility, size_t(std::lround(10000 * share)), {0, 0, 10000 * along}), w / std::sqrt(1 - c * c),
                0.01)
        << c << " " << w;
  }
}

TEST(SoftApertures, ACirclesEdgeIsHardAndAWallsIsWide) {
  for (const float radius : {0.6f, 1.0f}) EXPECT_LT(edge_of(first_of(scene_of({receiver(), hole(radius)}), soft)[0]), 0.2);
  EXPECT_LT(edge_of(first_of(scene_of({receiver()}), soft)[0]), 0.1) << "open sky";
  // Half of the hemisphere: area pi, so c = 1/2; its directions sum to pi / sqrt(2), a circle's to 3 pi / 4.
  const Aperture beside = first_of(scene_of({receiver(), wall()}), soft)[0];
  EXPECT_NEAR(edge_of(beside), std::sqrt(3 * (0.75 - std::sqrt(0.5))) / std::sin(pi_f / 3), 0.02);
  const Aperture hard = first_of(scene_of({receiver(), wall()}), {})[0];
  EXPECT_EQ(beside.w, hard.w);
  EXPECT_LT(glm::length(glm::normalize(glm::vec3(beside)) - glm::vec3(hard)), 1e-5f);
}

TEST(ChosenApertures, ADiscIsBlockedAndAHoleIsOpen) {
  const auto weight = [](const Scene& scene) { return glm::length(glm::vec3(first_of(scene, choice)[1])); };
  EXPECT_NEAR(weight(scene_of({receiver(), disc(0.6f)})), 1, 1e-5f);
  EXPECT_NEAR(weight(scene_of({receiver(), hole(0.6f)})), min_choice_length, 1e-5f);
  EXPECT_NEAR(weight(scene_of({receiver()})), min_choice_length, 1e-5f) << "nothing is blocked";
  const std::vector<Aperture> both = first_of(scene_of({receiver(), disc(0.6f)}), choice);
  EXPECT_NEAR(both[1].w, 0.6f, 0.02f);
  EXPECT_EQ(both[0], first_of(scene_of({receiver(), disc(0.6f)}), {})[0]);
}

// The models of the truth take the cap that counts: with weight 0 the open one's light, with 1 the blocked one's.
TEST(ChosenApertures, ModelsTakeTheCapThatCounts) {
  Scene scene = scene_of({receiver()});
  Light sun;
  sun.direction = -glm::normalize(glm::vec3(0.3f, 1, 0));
  sun.angular_radius = 0.2f;
  scene.lights = {sun};
  scene.ambient = glm::vec3(0.3f);
  const Occluders occluders(scene);
  const Aperture open(0, 1, 0, 0.35f), blocked(0.6f, 0.8f, 0, 0.5f);
  const auto lit = [&](ApertureKind kind, std::vector<Aperture> apertures, LightModel model) {
    const ShadingPoints points{1, 1, {{0, {0, 0, 0}, {0, 1, 0}, glm::vec3(1)}}, kind, std::move(apertures)};
    return direct_light(points, scene, occluders, model, {400, 400, 1, 1e-4f}, [](double) {})[0].r;
  };
  for (const LightModel model : {LightModel::exact_intersection, LightModel::integrated_cosine}) {
    const float of_open = lit({}, {open}, model), of_blocked = lit({.anti = true}, {blocked}, model);
    EXPECT_GT(std::abs(of_open - of_blocked), 0.05f);
    const Aperture faint(glm::vec3(blocked) * float(min_choice_length), blocked.w);
    EXPECT_NEAR(lit(choice, {open, faint}, model), of_open, 1e-5f);
    EXPECT_NEAR(lit(choice, {open, blocked}, model), of_blocked, 1e-5f);
  }
}

class ApertureKinds : public EachBackend {
 protected:
  // What the receiver shows of one sun in the plane z = 0, at an angle from the normal towards +x.
  float shown(Scene scene, const std::string& name, double angle, float radius = 0.05f) {
    for (Object& object : scene.objects)
      object.effects["surface"].textures["albedo"] = constant_texture("white", glm::vec4(1), TexelMeaning::colour);
    Light sun;
    sun.direction = -glm::vec3(std::sin(angle), std::cos(angle), 0);
    sun.angular_radius = radius;
    scene.lights = {sun};
    scene.views = {{"near", {3e-4f, 5e-3f, 3e-4f}, {3e-4f, 0, 3e-4f}, {0, 0, -1}, 2, 1e-3f, 1}};
    return pixel(picture(scene, name, 16), 8, 8).r;
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, ApertureKinds, api_parameters, backend_test_name);

// Beside a wall: of a sun within the circle the edge takes its share, as a hard edge takes of a sun as wide.
TEST_P(ApertureKinds, ASoftEdgeFadesTheSun) {
  const Scene scene = scene_of({receiver(), wall()});
  const Aperture aperture = first_of(scene, soft)[0];
  const double edge = edge_of(aperture), radius = 0.05, wide = std::sqrt(radius * radius + 4.0 / 3 * edge * edge);
  for (const double angle : {-0.1, 0.0, 0.1, 0.5}) {
    const glm::dvec3 sun(std::sin(angle), std::cos(angle), 0), axis = glm::normalize(glm::dvec3(aperture));
    const double apart = std::acos(glm::dot(sun, axis));
    ASSERT_LT(apart + radius, double(aperture.w)) << "the sun is within the circle";
    const double part = cap_intersection_area(double(aperture.w), wide, apart) / smaller_cap_area(wide, wide);
    EXPECT_NEAR(shown(scene, "soft_aperture", angle), part * std::cos(angle), 0.015) << angle;
    EXPECT_NEAR(shown(scene, "lens_cosine", angle), std::cos(angle), 0.01) << angle;
  }
}

// A disc overhead hides the sun behind it and no other; one aperture around the normal would let in the sun overhead.
TEST_P(ApertureKinds, TheChosenCapIsTheOneThatFits) {
  const Scene under_disc = scene_of({receiver(), disc(0.5f)}), under_hole = scene_of({receiver(), hole(0.5f)});
  for (const double angle : {0.0, 0.3}) {
    EXPECT_NEAR(shown(under_disc, "chosen_aperture", angle), 0, 0.01) << angle;
    EXPECT_NEAR(shown(under_hole, "chosen_aperture", angle), std::cos(angle), 0.01) << angle;
    EXPECT_GT(shown(under_disc, "lens_cosine", angle), 0.5f) << angle;
  }
  for (const double angle : {0.7, 1.2}) {
    EXPECT_NEAR(shown(under_disc, "chosen_aperture", angle), std::cos(angle), 0.01) << angle;
    EXPECT_NEAR(shown(under_hole, "chosen_aperture", angle), 0, 0.01) << angle;
  }
  EXPECT_NEAR(shown(under_hole, "chosen_aperture", 0.5), shown(under_hole, "lens_cosine", 0.5), 1e-4);
}

}  // namespace
}  // namespace lamina
