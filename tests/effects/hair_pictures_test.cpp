// SPDX-License-Identifier: Apache-2.0
// Pictures of cards against what their opacities say: which pixels are killed, what the smart blur may change, which way
// strands run, and what is bad input.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/made/hair_head.h"
#include "tests/effects/backends_agree.h"
#include "tests/effects/hair_scenes.h"

namespace lamina {
namespace {

class HairPictures : public EachBackend {
 protected:
  Image with(const Scene& scene, const std::string& name, const Parameters& parameters, uint32_t size = 32) {
    return DrawnFrame(*backend_, library(), scene,
                      {.variant = &variant(name), .width = size, .height = size, .parameters = parameters})
        .picture();
  }
};

TEST_P(HairPictures, KillCoversExactlyKOfSixteen) {
  for (const int k : {0, 1, 5, 8, 15, 16}) {
    const Scene scene = uniform_cards(static_cast<float>(k) / 16.0f);
    if (k > 0) {
      const Image image = picture(scene, "seed_pattern", 32);
      for (int block_y = 0; block_y < 32; block_y += 4)
        for (int block_x = 0; block_x < 32; block_x += 4) {
          int covered = 0;
          for (int i = 0; i < 16; ++i) covered += pixel(image, block_x + i % 4, block_y + i / 4).r > 0.5f;
          ASSERT_EQ(covered, k);
        }
      // 16 samples of one card are the same share of each pixel; where in its sixteenth a threshold lies is chance.
      const Image samples = picture(scene, "samples", 16);
      EXPECT_NEAR(mean_red(samples), k / 16.0, 0.004) << k;
      for (size_t i = 0; i < samples.rgba.size(); i += 4)
        ASSERT_NEAR(samples.rgba[i], static_cast<float>(k) / 16.0f, 1.01f / 16);
    } else {
      EXPECT_FALSE(make_plan(library(), uniform_cards(0)).of("hair")->called_for);
    }
  }
}

// One pattern for all cards covers the greater opacity; patterns without relation cover a + b - a b.
TEST_P(HairPictures, CardsOverEachOtherNeedPatternsOfTheirOwn) {
  for (const auto& [a, b] : {std::pair(0.5f, 0.5f), {0.25f, 0.75f}, {0.5f, 0.25f}}) {
    const Scene scene = uniform_cards(a, b);
    EXPECT_NEAR(mean_red(picture(scene, "seed_pattern", 64)), std::max(a, b), 1e-3);
    const double both = double(a) + double(b) - double(a) * double(b), error = 2 / std::sqrt(64.0 * 64);
    EXPECT_NEAR(mean_red(picture(scene, "white_noise", 64)), both, error) << a << " " << b;
    EXPECT_NEAR(mean_red(picture(scene, "sorted", 64)), both, 3e-3) << a << " " << b;
    EXPECT_GT(mean_red(picture(scene, "gradient_golden", 64)), std::max(a, b) + 0.5 * (both - std::max(a, b)));
  }
}

// Half of the picture is a card of half opacity, the other half is not; a wall behind.
Scene half_covered() {
  Object wall;
  wall.name = "wall";
  wall.mesh = card_squares({{-1, -0.8f, 0.8f}});
  Texels checks =
      filled(64, [](uint32_t x, uint32_t y) { return glm::vec4(glm::vec3((x / 3 + y / 5) % 2 == 0 ? 0.9f : 0.1f), 1); });
  wall.said.values = {{"albedo", {make_texture("checks", checks, TexelMeaning::colour)}}};
  std::vector<Object> objects;
  objects.push_back(
      hair_of(card_squares({{0, -0.6f, 0, {0.65f, 0.1f}, {0.85f, 0.9f}}}), two_opacities(0, 0.5f, {0.8f, 0.4f, 0.2f})));
  objects.push_back(std::move(wall));
  return declared_scene(std::move(objects));
}

TEST_P(HairPictures, TheSmartBlurNeverChangesBackground) {
  const Scene scene = half_covered();
  const Image sharp = picture(scene, "gradient_golden", 32);
  for (const std::string name : {"gradient_golden_blur_strand", "gradient_golden_blur_3x3"}) {
    const Image blurred = picture(scene, name, 32), none = with(scene, name, {{name + ".radius", 0}});
    EXPECT_EQ(none.rgba, sharp.rgba) << "radius 0 is to the bit";
    size_t changed = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        const bool same = pixel(blurred, x, y) == pixel(sharp, x, y);
        if (x >= 16) {
          ASSERT_TRUE(same) << x << " " << y;
        }
        changed += !same;
      }
    EXPECT_GT(changed, 300u);
  }
  // Along a strand that runs up the picture each pixel is the mean of five of its column, of those that are in the picture: so
  // what a column holds stays in it.
  const Image along = picture(scene, "gradient_golden_blur_strand", 32);
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 32; ++y) {
      glm::vec3 mean(0);
      int taps = 0;
      for (int row = std::max(y - 2, 0); row <= std::min(y + 2, 31); ++row, ++taps) mean += pixel(sharp, x, row);
      mean /= float(taps);
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel(along, x, y)[c], mean[c], 1.0f / 1024) << x << " " << y;
    }
}

TEST_P(HairPictures, ConstantHairStaysAsItIs) {
  const Scene scene = uniform_cards(1);
  for (const std::string name : {"gradient_golden_blur_strand", "gradient_golden_blur_3x3"}) {
    const Image image = picture(scene, name, 16);
    for (size_t i = 0; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 1.0f) << name;
  }
  // Nothing beside it comes in.
  const Scene half =
      declared_scene({hair_of(card_squares({{0, -0.6f, 0, {0.65f, 0.1f}, {0.85f, 0.9f}}}), two_opacities(0, 1))});
  const Image image = picture(half, "gradient_golden_blur_3x3", 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_EQ(pixel(image, x, y).r, x < 8 ? 1.0f : 0.0f) << x << " " << y;
}

// A card under one light, whose strands run as `direction` says.
Scene lit_card(glm::vec2 twice, glm::vec3 to_light) {
  Object hair = hair_of(card_squares({{0, -0.6f, 0.6f, {0.65f, 0.1f}, {0.85f, 0.9f}}}), two_opacities(0, 1, glm::vec3(0)));
  hair.said.values["hair.strength"] = {1.0};
  hair.said.values["hair.camera_light"] = {0.0};
  hair.said.values["hair.gloss_strength"] = {0.0};
  hair.said.values["hair.shift"] = {0.0};
  Texels direction{1, 1, {glm::vec4(0.5f + 0.5f * twice.x, 0.5f + 0.5f * twice.y, 0.5f, 1)}};
  hair.said.values["hair.direction"] = {make_texture("direction", direction, TexelMeaning::data)};
  Scene scene = declared_scene({std::move(hair)});
  scene.ambient = glm::vec3(0);
  Light light;
  light.name = "lamp";
  light.direction = -glm::normalize(to_light);
  scene.lights = {light};
  return scene;
}
double middle_red(const Image& image) {
  return double(image.rgba[(size_t(image.height / 2) * size_t(image.width) + size_t(image.width / 2)) * 4]);
}

// exp(-tan^2 of h / slope^2) / (4 ax ay sqrt(nl nv)) nl, the eye along the normal, the light 20 degrees off along or across.
TEST_P(HairPictures, StrandsRunAsTheirDirectionSays) {
  const double off = 20 * M_PI / 180, along_slope = 0.14, across_slope = 0.5;
  const auto ward = [&](double slope) {
    const double tangent = std::tan(off / 2) / slope;
    return std::exp(-tangent * tangent) * std::sqrt(std::cos(off)) / (4 * along_slope * across_slope);
  };
  const auto side = static_cast<float>(std::sin(off)), up = static_cast<float>(std::cos(off));
  const glm::vec3 to_right(side, 0, up), to_top(0, side, up);
  const glm::vec2 down_v(-1, 0), along_u(1, 0);
  const double along = ward(along_slope), across = ward(across_slope);
  EXPECT_NEAR(middle_red(picture(lit_card(down_v, to_right), "samples", 9)), across, 0.01 * across);
  EXPECT_NEAR(middle_red(picture(lit_card(down_v, to_top), "samples", 9)), along, 0.01 * along);
  EXPECT_NEAR(middle_red(picture(lit_card(along_u, to_right), "samples", 9)), along, 0.01 * along);
  EXPECT_NEAR(middle_red(picture(lit_card(along_u, to_top), "samples", 9)), across, 0.01 * across);
  for (const std::string name : {"direction_by_tangent", "direction_by_vertex"}) {  // which know no map: along v
    EXPECT_NEAR(middle_red(picture(lit_card(along_u, to_right), name, 9)), across, 0.01 * across) << name;
    EXPECT_NEAR(middle_red(picture(lit_card(along_u, to_top), name, 9)), along, 0.01 * along) << name;
  }
  // Texels of opposite angles are of one direction, in a texture of double angles.
  const double slanted = middle_red(picture(lit_card({0, 1}, glm::normalize(to_right + to_top)), "samples", 9));
  EXPECT_GT(std::abs(slanted - middle_red(picture(lit_card({0, -1}, glm::normalize(to_right + to_top)), "samples", 9))), 0.3);
}

// The two of greatest luminance, whatever their order; a light that is switched off is none.
TEST_P(HairPictures, TheTwoLightsThatMatterMostGiveTheHighlight) {
  const auto with_lights = [&](std::vector<float> strengths) {
    Scene scene = lit_card({-1, 0}, {0.1f, 0.1f, 1});
    const Light lamp = scene.lights[0];
    scene.lights.clear();
    for (const float strength : strengths) {
      scene.lights.push_back(lamp);
      scene.lights.back().radiance *= strength;
    }
    return middle_red(picture(scene, "samples", 9));
  };
  const double one = with_lights({1});
  EXPECT_NEAR(with_lights({0, 1}), one, 1e-3 * one);
  EXPECT_NEAR(with_lights({0.5f, 0.25f, 1}), 1.5 * one, 2e-3 * one);
  EXPECT_NEAR(with_lights({1, 0.25f, 0.5f}), 1.5 * one, 2e-3 * one);
  EXPECT_EQ(with_lights({}), 0);
}

TEST_P(HairPictures, WhatCannotBeHairIsRefused) {
  const auto refusal = [&](Scene scene) -> std::string {
    try {
      picture(scene, "seed_pattern", 8);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(declared_scene({hair_of(card_squares({{}}), Texels{1, 1, {glm::vec4(1)}})}))
                .find("object 'hair': has no alpha texture"),
            std::string::npos);
  Mesh flat = card_squares({{}});
  for (Vertex& vertex : flat.vertices) vertex.uv.y = 0.5f;
  EXPECT_NE(refusal(declared_scene({hair_of(flat, two_opacities(0, 1))})).find("has no tangents for hair"), std::string::npos);
  Object none = hair_of(card_squares({{}}), two_opacities(0, 1));
  none.said.values.erase("hair.albedo");
  try {
    declared_scene({std::move(none)});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has no hair_albedo; give hair.albedo"), std::string::npos) << error.what();
  }
}

// A texture that is opaque everywhere: nothing is killed, and no pass blurs.
TEST_P(HairPictures, OpaqueCardsAreSolid) {
  const Scene scene = declared_scene({hair_of(card_squares({{0, -0.6f, 0, {}, {1, 1}}}), two_opacities(1, 1))});
  const Plan plan = make_plan(library(), scene);
  ShaderCache shaders(backend_->info().api, library().shaders);
  for (const char* name :
       {"samples", "seed_pattern", "alpha_test", "gradient_golden_blur_strand", "gradient_golden_blur_3x3"}) {
    const Image image = picture(scene, name, 16);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) ASSERT_NEAR(pixel(image, x, y).r, x < 8 ? 1 : 0, 1e-3) << name << " " << x << " " << y;
    for (const GraphPass& pass : make_graph(plan, configuration_with(plan, variant(name)), scene, shaders).passes)
      EXPECT_TRUE(pass.draws.empty() || (pass.pass->name != "blur" && pass.pass->name != "strands")) << name;
  }
}

// Every variant on two backends, of the built-in head. Pixels whose opacity is a threshold's may differ.
TEST(HairBackends, AgreeAndHaveNoNaN) {
  expect_backends_agree("hair", {load_scene("hair_head", builtin_library())}, 48, {{"layers", 48}});
}

INSTANTIATE_TEST_SUITE_P(Backends, HairPictures, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
