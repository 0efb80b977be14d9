// SPDX-License-Identifier: Apache-2.0
// The layered material's pictures and counts against the chapter's formulas, on every backend.
#include <cmath>
#include <numeric>

#include "harness/quality/quality.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {
namespace {

class LayeredMaterial_ : public EachBackend {};
INSTANTIATE_TEST_SUITE_P(Backends, LayeredMaterial_, backend_parameters, backend_test_name);
constexpr std::string_view all_variants[] = {"light_map", "normal_map_taps", "vertex_normal"};
// Those that take other filters or other light in place of the chapter's, too.
constexpr std::string_view every_variant[] = {
    "light_map", "normal_map_taps", "vertex_normal", "base_level_taps", "blurred_once",    "footprint_map", "golden_disc",
    "half_map",  "mean_normal",     "merged_taps",   "one_fetch_disc",  "one_light_fetch", "reached_light", "ring_disc"};
EffectValues& layers_of(Scene& scene) { return scene.objects[0].effects.at("layered_material"); }
// Half floats keep 11 bits; albedos are stored in 8.
constexpr float tolerance = 0.004f;

// The alpha channel is transparency: 1 shows the inner layer, 0 the outer. Head-on, N.V = 1; light is 1, so the picture is the
// albedo.
TEST_P(LayeredMaterial_, TransparencyOneShowsTheInnerLayerAndZeroTheOuter) {
  for (const std::string_view name : every_variant) {
    EXPECT_NEAR(pixel(picture(quad_scene({4, 1, glm::vec3(0.5f), glm::vec3(0.25f)}), name), 32, 32).r, 0.25f, tolerance)
        << name;
    EXPECT_NEAR(pixel(picture(quad_scene({4, 0, glm::vec3(0.5f), glm::vec3(0.25f)}), name), 32, 32).r, 0.5f, tolerance) << name;
    EXPECT_NEAR(pixel(picture(quad_scene({4, 0.5f, glm::vec3(0.5f), glm::vec3(0.25f)}), name), 32, 32).r, 0.375f, tolerance)
        << name;
  }
}

// Red where u is in the picture's left half, green where v is in its upper half; the square shows it twice along both axes.
TEST_P(LayeredMaterial_, APictureWrapsAsItsModelAsksAlongBothAxes) {
  Texels halves = filled(64, [](uint32_t x, uint32_t y) { return glm::vec4(x < 32 ? 1 : 0, y < 32 ? 1 : 0, 0, 0); });
  Scene scene = quad_scene({0, 0});
  for (Vertex& vertex : scene.objects[0].mesh.vertices) vertex.uv *= 2.0f;
  const auto seen = [&](std::optional<TextureWraps> wraps) {
    halves.wraps = wraps;
    layers_of(scene).textures["outer_albedo"] = make_texture("halves", halves, TexelMeaning::colour);
    const glm::vec3 at = pixel(picture(scene, "vertex_normal"), 56, 40);  // u = 1.77, v = 1.27
    return std::pair(at.r > 0.5f, at.g > 0.5f);
  };
  EXPECT_EQ(seen({}), std::pair(false, true));
  EXPECT_EQ(seen(TextureWraps{Wrap::mirror, Wrap::clamp}), std::pair(true, false));
  EXPECT_EQ(seen(TextureWraps{Wrap::repeat, Wrap::mirror}), std::pair(false, false));
  EXPECT_EQ(seen(TextureWraps{Wrap::clamp, Wrap::repeat}), std::pair(false, true));
}

// Seen at angle a from the normal with transparency 1 the weight of the inner layer is N.V = cos a.
TEST_P(LayeredMaterial_, GrazingViewPrefersTheOuterLayer) {
  for (const double degrees : {20.0, 45.0, 70.0}) {
    Scene scene = quad_scene({4, 1, glm::vec3(0.0f), glm::vec3(0.25f)});
    const float angle = float(degrees * M_PI / 180);
    scene.views[0].eye = {10 * std::sin(angle), 0, 10 * std::cos(angle)};
    for (const std::string_view name : all_variants)
      EXPECT_NEAR(pixel(picture(scene, name), 32, 32).r, 0.25f * std::cos(angle), 2 * tolerance) << name << " at " << degrees;
  }
}

// With a flat normal map the transmitted ray goes on along -V: at angle a it meets the inner layer d tan a texels further on,
// away from the eye. An inner layer whose red rises by a known slope along u then shows that offset. Texel size is that of the
// bound texture: 64 and 128 texels give offsets of d/64 and d/128 of the texture.
TEST_P(LayeredMaterial_, ParallaxOffsetIsThicknessTimesTangentInTexelsOfTheBoundTexture) {
  for (const uint32_t size : {64u, 128u}) {
    Scene scene = quad_scene({6, 1, glm::vec3(0.0f), glm::vec3(0.0f), size});
    layers_of(scene).textures["inner_albedo"] = make_texture(
        "ramp", filled(size, [&](uint32_t x, uint32_t) { return glm::vec4((float(x) + 0.5f) / float(size), 0, 0, 1); }),
        TexelMeaning::colour);
    const float angle = float(M_PI) / 4;
    scene.views[0].eye = {10 * std::sin(angle), 0, 10 * std::cos(angle)};
    // The centre of the frame is the middle of four pixels; the mean of the taps' offsets is the disc's own.
    double disc_x = 0;
    for (const double x : {-0.326212, -0.840144, -0.695914, -0.203345, 0.96234, 0.473434, 0.519456, 0.185461, 0.507431, 0.89642,
                           -0.32194, -0.791559})
      disc_x += x / 13;
    const double s = 6 / std::cos(angle);
    const double expected = 0.5 + (-6 * std::tan(angle) + s * disc_x) / size;
    for (const std::string_view name : all_variants) {
      const Image image = picture(scene, name);
      const float middle = (pixel(image, 31, 32).r + pixel(image, 32, 32).r) / 2 / std::cos(angle);
      EXPECT_NEAR(middle, expected, 3 * tolerance) << name << ", " << size << " texels";
    }
  }
}

// A mapped normal turned towards +u by t reflects the head-on view by 2t, so that the ray arrives d tan 2t texels along +u.
TEST_P(LayeredMaterial_, MappedNormalTurnsTheTransmittedRayByTwiceItsAngle) {
  Scene scene = quad_scene({5, 1, glm::vec3(0.0f), glm::vec3(0.0f)});
  EffectValues& layers = layers_of(scene);
  const float tilt = 0.2f;
  layers.textures["outer_normal"] = make_texture(
      "tilted",
      filled(64, [&](uint32_t,
                     uint32_t) { return glm::vec4(0.5f + 0.5f * std::sin(tilt), 0.5f, 0.5f + 0.5f * std::cos(tilt), 1); }),
      TexelMeaning::normal);
  layers.textures["inner_albedo"] =
      make_texture("ramp", filled(64, [&](uint32_t x, uint32_t) { return glm::vec4((float(x) + 0.5f) / 64, 0, 0, 1); }),
                   TexelMeaning::colour);
  const Image image = picture(scene, "vertex_normal");
  double disc_x = 0;
  for (const double x : {-0.326212, -0.840144, -0.695914, -0.203345, 0.96234, 0.473434, 0.519456, 0.185461, 0.507431, 0.89642,
                         -0.32194, -0.791559})
    disc_x += x / 13;
  const double expected = 0.5 + (5 * std::tan(2 * tilt) + 5 / std::cos(2 * tilt) * disc_x) / 64;
  EXPECT_NEAR((pixel(image, 31, 32).r + pixel(image, 32, 32).r) / 2 / std::cos(tilt), expected, 4 * tolerance);
}

// Light straight from the eye, and a normal map whose middle texel alone is flat; elsewhere it leans by 60 degrees, where N.L
// is one half. Of 13 taps of one weight the one in the middle is lit by 1, the others, which lie three texels away or more, by
// 0.5.
TEST_P(LayeredMaterial_, InnerLightIsTheMeanOfThirteenTaps) {
  Scene scene = quad_scene({6, 1, glm::vec3(0.0f), glm::vec3(1.0f)});
  scene.ambient = glm::vec3(0);
  scene.lights.push_back({"from_the_eye", Light::Kind::directional, {0, 0, -1}, {}, glm::vec3(1)});
  const float lean = float(M_PI) / 3;
  layers_of(scene).textures["outer_normal"] = make_texture(
      "flat_in_the_middle",
      filled(64,
             [&](uint32_t x, uint32_t y) {
               return x == 32 && y == 32 ? glm::vec4(0.5f, 0.5f, 1, 1)
                                         : glm::vec4(0.5f + 0.5f * std::sin(lean), 0.5f, 0.5f + 0.5f * std::cos(lean), 1);
             }),
      TexelMeaning::normal);
  // A light map filters the light of the middle texel with its neighbours', so the variant that lights each tap is asked.
  EXPECT_NEAR(pixel(picture(scene, "normal_map_taps"), 32, 32).r, (1 + 12 * 0.5) / 13, tolerance);
}

// A lamp over the middle, at one and a half and at three metres: a quarter of the light at twice the distance.
TEST_P(LayeredMaterial_, LampsFallOffWithTheSquareOfTheDistance) {
  for (const float distance : {1.5f, 3.0f}) {
    Scene scene = quad_scene({4, 0, glm::vec3(1.0f), glm::vec3(0.0f)});
    scene.ambient = glm::vec3(0);
    scene.lights.push_back({"lamp", Light::Kind::point, {}, {0, 0, distance}, glm::vec3(1)});
    for (const std::string_view name : all_variants)
      EXPECT_NEAR(pixel(picture(scene, name), 32, 32).r, 1 / (distance * distance), tolerance) << name << " at " << distance;
  }
}

TEST_P(LayeredMaterial_, CompositeMakesTheChaptersNumberOfFetches) {
  const Scene scene = bumpy_scene(6, 1);
  const Plan plan = make_plan(library(), scene);
  ShaderCache shaders(backend_->info().api, library().shaders);
  SceneResources resources(*backend_, scene, library(), 96, 80);
  const std::map<std::string_view, uint64_t> expected = {
      {"light_map", 29},     {"normal_map_taps", 28}, {"vertex_normal", 15}, {"one_light_fetch", 17},
      {"half_map", 17},      {"merged_taps", 9},      {"ring_disc", 11},     {"golden_disc", 29},
      {"one_fetch_disc", 5}, {"blurred_once", 8},     {"mean_normal", 17}};
  for (const auto& [name, fetches] : expected) {
    const Graph graph = make_graph(plan, configuration_with(plan, variant(name)), scene, shaders);
    Frame frame(resources, graph, Build::counting);
    frame.run_once(Timing::off);
    frame.run(0, Timing::off);
    const PassCounts composite = frame.frame_counts().back();
    EXPECT_GT(composite.fragments, 500u);
    EXPECT_EQ(composite.fetches(), fetches * composite.fragments) << name;
    for (const TextureFetches& texture : composite.by_texture) {
      const uint64_t reads = std::accumulate(texture.levels.begin(), texture.levels.end(), uint64_t{0});
      EXPECT_GE(reads, texture.fetches) << name << " " << texture.texture;
      EXPECT_LE(reads, 2 * texture.fetches) << "two levels at most: " << name << " " << texture.texture;
    }
    const Mask covered = frame.coverage("layered_material");
    uint64_t pixels = 0;
    for (const uint8_t on : covered.on) pixels += on;
    EXPECT_EQ(pixels, composite.fragments) << "one square covers no pixel twice";
    EXPECT_EQ(composite.vertices, 4u) << name;
  }
}

TEST_P(LayeredMaterial_, CountingBuildDrawsTheSamePictureToTheBit) {
  const Scene scene = bumpy_scene(6, 1);
  for (const std::string_view name : all_variants)
    EXPECT_EQ(picture(scene, name).rgba, picture(scene, name, 64, Build::counting).rgba) << name;
}

TEST_P(LayeredMaterial_, SameInputsGiveTheSameBits) {
  const Scene scene = bumpy_scene(6, 1);
  for (const std::string_view name : all_variants) EXPECT_EQ(picture(scene, name).rgba, picture(scene, name).rgba) << name;
}

// Culling changes no pixel. The un-culled picture is made by telling the plan a fact that is not so.
TEST_P(LayeredMaterial_, CullingAtThicknessZeroChangesNoPixel) {
  const Scene culled = bumpy_scene(0, 1);
  Scene whole = culled;
  layers_of(whole).numbers["thickness"] = 1e-30f;  // above 0 for the plan, nothing for the picture
  for (const std::string_view name : every_variant) EXPECT_EQ(picture(culled, name).rgba, picture(whole, name).rgba) << name;
}

TEST_P(LayeredMaterial_, CullingUnderAnOpaqueLayerChangesNoPixel) {
  const Scene whole = bumpy_scene(6, 0);
  Scene culled = whole;
  layers_of(culled).facts["transparency"] = 0;
  Scene uncut = whole;
  layers_of(uncut).facts["transparency"] = 1;
  for (const std::string_view name : every_variant) EXPECT_EQ(picture(culled, name).rgba, picture(uncut, name).rgba) << name;
}

TEST_P(LayeredMaterial_, CullingDropsFetchesAndTextures) {
  const auto fetches_per_fragment = [&](const Scene& scene, std::string_view name) {
    const Plan plan = make_plan(library(), scene);
    ShaderCache shaders(backend_->info().api, library().shaders);
    SceneResources resources(*backend_, scene, library(), 64, 64);
    const Graph graph = make_graph(plan, configuration_with(plan, variant(name)), scene, shaders);
    Frame frame(resources, graph, Build::counting);
    frame.run_once(Timing::off);
    frame.run(0, Timing::off);
    const PassCounts composite = frame.frame_counts().back();
    return std::pair(composite.fetches() / composite.fragments, resources.textures_uploaded());
  };
  using Result = std::pair<uint64_t, size_t>;
  EXPECT_EQ(fetches_per_fragment(bumpy_scene(0, 1), "light_map"), Result(4, 3));        // light, outer, normal, inner
  EXPECT_EQ(fetches_per_fragment(bumpy_scene(0, 1), "vertex_normal"), Result(3, 3));    // outer, normal, inner
  EXPECT_EQ(fetches_per_fragment(bumpy_scene(6, 0), "normal_map_taps"), Result(2, 2));  // outer, normal
  EXPECT_EQ(fetches_per_fragment(bumpy_scene(6, 0), "light_map").second, 2u);  // the inner layer's texture is never there
}

// A still scene makes one light map; a moving one makes one every frame.
TEST_P(LayeredMaterial_, StillSceneMakesItsLightMapOnce) {
  Scene scene = bumpy_scene(6, 1);
  const auto names = [&](bool moves) {
    scene.mesh_moves = moves;
    const Plan plan = make_plan(library(), scene);
    ShaderCache shaders(backend_->info().api, library().shaders);
    SceneResources resources(*backend_, scene, library(), 32, 32);
    const Graph graph = make_graph(plan, configuration_with(plan, variant("light_map")), scene, shaders);
    Frame frame(resources, graph, Build::timed);
    return std::pair(frame.once_names(), frame.frame_names());
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(false),
            std::pair(Names({"chart_seeds", "chart_distance", "light", "dilate", "light_mips"}), Names({"composite"})));
  EXPECT_EQ(names(true),
            std::pair(Names({"chart_seeds", "chart_distance"}), Names({"light", "dilate", "light_mips", "composite"})));
}

// A chart over a quarter of the texture, lit with 1: with dilation no tap, however far the layer's thickness offsets it, reads
// background.
TEST_P(LayeredMaterial_, NoTapReadsBackgroundBeyondTheCharts) {
  Scene scene = quad_scene({30, 1, glm::vec3(0.5f), glm::vec3(0.25f)});
  for (Vertex& vertex : scene.objects[0].mesh.vertices) vertex.uv = vertex.uv * 0.5f + 0.25f;
  scene.views[0].eye = {3, 2, 5};
  scene.views[0].fov_y_degrees = 15;
  layers_of(scene).textures["outer_albedo"] = constant_texture("white", {1, 1, 1, 1}, TexelMeaning::colour);
  layers_of(scene).textures["inner_albedo"] =
      make_texture("inner", filled(64, [](uint32_t, uint32_t) { return glm::vec4(1); }), TexelMeaning::colour);
  const Image image = picture(scene, "light_map");
  size_t drawn = 0;
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] == 0) continue;
    ++drawn;
    EXPECT_NEAR(image.rgba[i], 1, tolerance);
  }
  EXPECT_GT(drawn, 100u);
}

TEST(LayeredMaterialAcrossBackends, OpenGlAgreesWithVulkan) {
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code());
  const Scene scene = bumpy_scene(6, 1);
  const Plan plan = make_plan(library, scene);
  std::map<std::string, std::map<std::string, Image>> pictures;  // [backend][variant]
  for (const std::string_view name : backend_names()) {
    try {
      const auto backend = open_backend(name, {"", true});
      ShaderCache shaders(backend->info().api, library.shaders);
      SceneResources resources(*backend, scene, library, 128, 128);
      for (const VariantManifest& variant : library.effect("layered_material").variants) {
        const Graph graph = make_graph(plan, configuration_with(plan, variant), scene, shaders);
        Frame frame(resources, graph, Build::timed);
        frame.run_once(Timing::off);
        frame.run(0, Timing::off);
        pictures[std::string(name)][variant.name] = frame.picture();
      }
    } catch (const Error& error) {
      std::cout << name << " left out: " << error.what() << "\n";
    }
  }
  if (!pictures.contains("vulkan") || pictures.size() < 2) GTEST_SKIP() << "needs Vulkan and an OpenGL backend";
  for (const auto& [backend, by_variant] : pictures)
    for (const auto& [name, image] : by_variant) {
      const DisplayImage reference = to_display(pictures.at("vulkan").at(name));
      EXPECT_GE(psnr_db(to_display(image), reference), 45) << backend << " " << name;
      // Flipped in x or in y it would be another picture: the bound proves the orientation.
      for (const bool in_x : {true, false}) {
        Image flipped = image;
        for (int y = 0; y < image.height; ++y)
          for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c)
              flipped.rgba[size_t((y * image.width + x) * 4 + c)] = image.rgba[size_t(
                  ((in_x ? y : image.height - 1 - y) * image.width + (in_x ? image.width - 1 - x : x)) * 4 + c)];
        EXPECT_LT(psnr_db(to_display(flipped), reference), 30) << backend << " " << name;
      }
    }
}

}  // namespace
}  // namespace lamina
