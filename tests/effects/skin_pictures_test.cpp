// SPDX-License-Identifier: Apache-2.0
// Pictures of skin against closed forms: an edge of light on a plate, constant light, balls; features that are left out; bad
// input.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/truth/view_rays.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/skin_scenes.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

class SkinPictures : public EachBackend {
 protected:
  Image with(const Scene& scene, const std::string& name, const SkinNumbers& said, uint32_t size = 64) {
    Parameters parameters;
    for (const auto& [parameter, value] : said)
      if (variant(name).parameter(parameter)) parameters[name + "." + parameter] = value;
    return DrawnFrame(*backend_, library(), scene,
                      {.variant = &variant(name), .width = size, .height = size, .parameters = parameters, .aspect = 1})
        .picture();
  }
};

TEST_P(SkinPictures, AnEdgeOfLightFallsAsTheProfileSays) {
  const Scene scene = edge_of_light_scene();
  // Measured in red: .0013, .029 (eleven taps a direction stand in steps; two exact Gaussians err by .013), .082 and .029; .19
  // without diffusion.
  for (const auto& [name, red, rest] : {std::tuple("six_gaussians", .003, .002),
                                        {"two_gaussians", .032, .016},
                                        {"one_gaussian", .09, .02},
                                        {"screen_separable", .035, .010}}) {
    SCOPED_TRACE(name);
    const glm::dvec3 error = edge_error(scene, with(scene, name, {{"map_texels", 256}, {"shadow_texels", 2048}}, 128));
    EXPECT_LT(error.r, red);
    EXPECT_LT(std::max(error.g, error.b), rest);
  }
  EXPECT_GT(edge_error(scene, with(scene, "plain_lambert", {{"shadow_texels", 2048}}, 128)).r, 0.15);
}

// A strip of light, 8 mm wide with soft edges: diffusion moves its light, and keeps all of it.
TEST_P(SkinPictures, DiffusionKeepsEnergy) {
  std::vector<Object> objects;
  objects.push_back(skin_plate({{"skin.penumbra", 3}}));
  for (const float side : {-1.0f, 1.0f}) {
    Object blocker;
    blocker.name = side < 0 ? "left" : "right";
    blocker.mesh =
        skin_square(std::min(0.004f * side, 0.06f * side), std::max(0.004f * side, 0.06f * side), -0.06f, 0.06f, 0.005f);
    blocker.world_from_object[3].x = 0.00375f;  // the light slants by .6 over .8
    objects.push_back(std::move(blocker));
  }
  Light lamp = directional_light("lamp", {0.6f, 0, 0.8f}, glm::vec3(1.25f));
  lamp.casts = true;
  Scene scene = skin_scene(std::move(objects), {lamp}, glm::vec3(0));
  View& view = scene.views[0];
  view.eye = {0, 0, 0.2f};
  view.near_m = 0.1f, view.far_m = 0.3f;
  for (size_t i = 1; i < scene.objects.size(); ++i)  // blockers face away: the eye looks through them, a lamp's map does not
    std::swap(scene.objects[i].mesh.indices[1], scene.objects[i].mesh.indices[2]),
        std::swap(scene.objects[i].mesh.indices[4], scene.objects[i].mesh.indices[5]);
  const auto strip = [&](const std::string& name) {
    const Image image =
        with(scene, name, {{"map_texels", 256}, {"shadow_texels", 2048}, {"shadow_taps", 64}, {"precision", 1}}, 128);
    glm::dvec3 sum(0);
    for (int x = 0; x < 128; ++x) sum += glm::dvec3(pixel(image, x, 64)) / 128.0;
    return sum;
  };
  const double right = 8 / (2 * 200 * std::tan(glm::radians(4.0)));  // of what is seen
  const glm::dvec3 plain = strip("plain_lambert");
  EXPECT_NEAR(plain.r, right, 0.015 * right) << "edges lie between pixels";
  for (const char* name : {"six_gaussians", "two_gaussians", "one_gaussian", "mip_chain", "taps_12", "screen_separable"}) {
    const glm::dvec3 found = strip(name), of = name == std::string("screen_separable") ? plain : glm::dvec3(right);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], of[c], 0.01 * of[c]) << name << " " << c;
  }
}

// A pixel is 16 texels of the light map. Diffusion has smoothed what lies between: a point's light is asked for, not the mean
// of the texels around it, which wipes the features off a small face.
TEST_P(SkinPictures, WhatIsFarAwayIsNotBlurredAgain) {
  const Scene scene = edge_of_light_scene();
  const glm::dvec3 error = edge_error(scene, with(scene, "six_gaussians", {{"map_texels", 256}, {"precision", 1}}, 16));
  EXPECT_LT(std::max({error.r, error.g, error.b}), .005);
}

TEST_P(SkinPictures, ConstantLightIsUnchanged) {
  std::vector<Object> objects;
  objects.push_back(skin_plate());
  const Scene scene = skin_scene(std::move(objects), {}, {0.25f, 0.5f, 1});
  for (const std::string name : {"six_gaussians", "two_gaussians", "one_gaussian", "mip_chain", "taps_12", "taps_13",
                                 "screen_separable", "screen_nine_taps", "screen_burley", "clement_layers"}) {
    SCOPED_TRACE(name);
    const Image image = with(scene, name, {{"map_texels", 32}}, 16);
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
      ASSERT_NEAR(image.rgba[i], 0.25f, 1e-3f * 0.25f);
      ASSERT_NEAR(image.rgba[i + 1], 0.5f, 1e-3f * 0.5f);
      ASSERT_NEAR(image.rgba[i + 2], 1, 1e-3f);
    }
  }
}

// Near the chart's equator: elsewhere circles of latitude are not straight, as the separable blur takes them to be.
TEST_P(SkinPictures, ABallIsLitAsTheClosedFormSays) {
  Object ball = skin_object("ball", globe_mesh(193, 97), glm::vec3(1), {{"skin.specular", 0}});
  ball.world_from_object = glm::mat4(0.005f);
  ball.world_from_object[3][3] = 1;
  std::vector<Object> objects;
  objects.push_back(std::move(ball));
  const glm::vec3 to_light = glm::normalize(glm::vec3(1, 0, 0.25f));
  Scene scene = skin_scene(std::move(objects), {directional_light("lamp", to_light, glm::vec3(1))}, glm::vec3(0));
  scene.views[0].eye = {0, 0, 0.2f};
  scene.views[0].fov_y_degrees = 3.1f;
  const DiffusionProfile profile = default_profile();
  for (const auto& [name, most] : {std::pair("six_gaussians", .005),
                                   {"spherical_gaussians", .010},
                                   {"preintegrated", .004},
                                   {"preintegrated_ring", .026},
                                   {"curvature_wrap", .045}}) {
    SCOPED_TRACE(name);
    const Image image = with(scene, name, {{"map_texels", 256}, {"precision", 1}}, 64);
    double error = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const glm::dvec3 eye(scene.views[0].eye), d = ViewRays(scene.views[0], 64, 64).direction(x, y);
        const double along = -glm::dot(eye, d), beside = glm::dot(eye, eye) - along * along, r = 0.005;
        if (beside > 0.9 * r * r) continue;
        const glm::dvec3 n = (eye + d * (along - std::sqrt(r * r - beside))) / r;
        if (std::abs(n.y) > 0.35) continue;
        const glm::dvec3 right = profile.sphere(glm::dot(n, glm::dvec3(to_light)), 5);
        for (int c = 0; c < 3; ++c) error = std::max(error, std::abs(double(pixel(image, x, y)[c]) - right[c]));
      }
    EXPECT_LT(error, most);
  }
}

// With a number at 0 its code is not there, and with the least number it does nothing yet: both are the same picture.
TEST_P(SkinPictures, WhatIsNotThereCostsNothingAndChangesNothing) {
  for (const auto& [key, feature] : {std::pair("skin.oil", "OIL"),
                                     {"skin.rim", "RIM"},
                                     {"skin.melanin", "MELANIN"},
                                     {"skin.back_scattering", "BACK_SCATTERING"}}) {
    SCOPED_TRACE(key);
    std::vector<Image> pictures;
    for (const double number : {0.0, 1e-12}) {
      const Scene scene = edge_of_light_scene({{key, number}, {"skin.specular", 0.3}});
      const Plan plan = make_plan(library(), scene, 1);
      for (const FeaturePlan& planned : plan.of("skin")->features)
        if (planned.define == feature) {
          EXPECT_EQ(planned.on, number > 0);
        }
      pictures.push_back(picture(scene, "plain_lambert", 32));
    }
    EXPECT_EQ(pictures[0].rgba, pictures[1].rgba);
  }
  // Neither maps of lights nor samplers of them where no light casts.
  Scene dark = edge_of_light_scene();
  dark.lights[0].casts = false;
  const Plan plan = make_plan(library(), dark, 1);
  ShaderCache shaders(backend_->info().api, library().shaders);
  const Graph graph = make_graph(plan, configuration_with(plan, variant("six_gaussians")), dark, shaders);
  for (const GraphPass& pass : graph.passes) EXPECT_NE(pass.pass->name, "shadow");
}

TEST_P(SkinPictures, AMeshWithoutAUniqueUnwrapFailsByName) {
  Scene scene = edge_of_light_scene();
  scene.objects[0].unwrap_problem = "texture coordinates span 3 tiles";
  EXPECT_GT(pixel(picture(scene, "plain_lambert", 16), 15, 8).r, 0.1f) << "others go on";
  try {
    picture(scene, "six_gaussians", 16);
    ADD_FAILURE() << "drawn all the same";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be drawn unwrapped, as pass '"), std::string::npos) << error.what();
  }
}

TEST_P(SkinPictures, AWrongProfileIsBadInput) {
  for (const auto& [key, number, says] : {std::tuple("skin.red_5", 0.2, "the red weights of the profile sum to 0.842"),
                                          {"skin.sigma_3", 0.0, "Gaussian 3 of the profile has a width of 0"}}) {
    const Scene scene = edge_of_light_scene({{key, number}});
    try {
      picture(scene, "spherical_gaussians", 8);
      ADD_FAILURE() << key;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, SkinPictures, api_parameters, backend_test_name);

// An edge of light, highlights and all that can be asked for.
TEST(SkinBackends, AgreeAndHaveNoNaN) {
  const Scene plate = edge_of_light_scene({{"skin.specular", 0.34},
                                           {"skin.penumbra", 3},
                                           {"skin.oil", 0.3},
                                           {"skin.melanin", 0.2},
                                           {"skin.rim", 0.3},
                                           {"skin.back_scattering", 0.3}});
  expect_backends_agree("skin", {plate}, 48, {{"map_texels", 64}});
}

}  // namespace
}  // namespace lamina
