// SPDX-License-Identifier: Apache-2.0
// Pictures of light through objects against closed forms, on every backend.
#include "tests/effects/translucent_scenes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "harness/quality/quality.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

class TranslucentScenes : public EachBackend {
 protected:
  static constexpr uint32_t size = 48;

  static glm::dvec3 middle(const Image& image) { return glm::dvec3(pixel(image, image.width / 2, image.height / 2)); }
  // exp(-thickness) at the picture's middle, which lies opposite the light: what is left of its factor, wrap and colour aside.
  static double thickness_at_middle(const Image& image, const Scene& scene) {
    const auto& numbers = scene.objects[0].effects.at("translucency").numbers;
    const double wrap = numbers.at("wrap"), eta = numbers.at("refraction_index");
    const double colour = diffuse_reflectance(stored_albedo(scene.objects[0]).g, eta);
    return -std::log(middle(image).g / (colour / (1 + wrap))) / numbers.at("extinction_green");
  }
};

// A point's eye ray sees light scattered once in a slab that is lit along its normal.
TEST_P(TranslucentScenes, TheMarchIsTheClosedFormOfASlab) {
  for (const float tau : {1.0f, 2.0f})
    for (const double mu : {1.0, 0.3}) {
      const Mesh mesh = block_mesh({{{-30, -tau, -30}, {30, 0, 30}}}, 30);
      const auto sine = static_cast<float>(std::sqrt(1 - mu * mu));
      const Scene scene = lit_alone(translucent(mesh, {.albedo = glm::vec3(0.95f)}), {0, -1, 0},
                                    {4 * sine, static_cast<float>(4 * mu), 0.001f}, 1);
      const double albedo = stored_albedo(scene.objects[0]).g;
      const double expected = albedo / 4 / (1 + mu) * -std::expm1(-double(tau) * (1 + 1 / mu));
      EXPECT_NEAR(middle(picture(scene, "refracted_march", size)).g, expected, 0.01 * expected) << tau << " " << mu;
    }
}

// Each pixel's ray and light, by rays and 32 steps, on the same sphere: the map, its filter and 8 steps must come close.
TEST_P(TranslucentScenes, TheMarchOfASphereIsTheDoubleForm) {
  for (const double eta : {1.0, 1.3, 1.4, 1.5}) {
    const Scene scene = lit_alone(translucent(sphere_mesh(), {{0.7f, 1.5f, 3}, eta, 1, 0.25, glm::vec3(0.8f)}),
                                  {1, -0.5f, 0.4f}, {0, 0, 5}, 26);
    const Image image = picture(scene, "refracted_march", size);
    EXPECT_EQ(nonfinite_pixels(image), 0u);
    const Solids solids(scene);
    const glm::dvec3 albedo = stored_albedo(scene.objects[0]);
    double difference = 0, all = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double scale = std::tan(glm::radians(13.0));
        const glm::dvec3 along =
            glm::normalize(glm::dvec3(((x + 0.5) / size * 2 - 1) * scale, (1 - (y + 0.5) / size * 2) * scale, -1));
        const double b = 5 * along.z, root = b * b - 24;
        if (root < 0.15) continue;  // silhouettes
        const glm::dvec3 hit = glm::dvec3(0, 0, 5) + along * (-b - std::sqrt(root));
        const LitPoint point{0, hit * 0.9995, hit, -along, albedo};
        const glm::dvec3 exact =
            single_scattering(solids, scene, point, Refraction::flat) + slab_scattering(solids, scene, point, Refraction::flat);
        difference += glm::length(exact - glm::dvec3(pixel(image, x, y)));
        all += glm::length(exact);
      }
    EXPECT_LT(difference, 0.03 * all) << eta;
  }
}

TEST_P(TranslucentScenes, AHoleCountsForTheDepthMapAndNotForTheSums) {
  const Scene scene = lit_alone(translucent(shell_mesh(0.8f), {}), {0, -1, 0}, {0, -5, 0.001f}, 8);
  EXPECT_NEAR(thickness_at_middle(picture(scene, "one_sample", size), scene), 2.0, 0.02);
  EXPECT_NEAR(thickness_at_middle(picture(scene, "filtered_samples", size), scene), 2.0, 0.02);
  EXPECT_NEAR(thickness_at_middle(picture(scene, "light_sums", size), scene), 0.4, 0.02);
}

// All four faces along the light through a block with a hole: the light side, the hole's two walls, the far side.
TEST_P(TranslucentScenes, SumsAreRightOnEveryWallOfAHole) {
  const Mesh mesh = block_mesh({{{-2, -1, -2}, {2, 1, 2}}, {{-1, -0.5f, -2}, {1, 0.4f, 2}, false}}, 1);
  struct Case {
    glm::vec3 eye, target;
    double thickness;  // before the point; light falls along -y
  };
  // In the hole the eye looks up at its ceiling and down at its floor, slantwise through its mouth.
  for (const auto& [eye, target, thickness] : {Case{{0, -6, 0.01f}, {0, -1, 0}, 1.1},
                                               {{0, -1.2f, 5}, {0, 0.4f, 1}, 0.6},
                                               {{0, 1.0f, 5}, {0, -0.5f, 1}, 0.6},
                                               {{0, 6, 0.01f}, {0, 1, 0}, 0}}) {
    const Scene scene = lit_alone(translucent(mesh, {}), {0, -1, 0}, eye, 2, target);
    const Image image = picture(scene, "light_sums", size);
    const double wrap = 0.25, colour = diffuse_reflectance(stored_albedo(scene.objects[0]).g, 1);
    const bool away = thickness == 1.1 || target.y == 0.4f;
    const double factor = away ? 1 / (1 + wrap) : 1;
    EXPECT_NEAR(-std::log(middle(image).g / (colour * factor)), thickness, 0.03) << target.y;
  }
}

// A sphere's far side, unrefracted: s = -2 R N.L. Over its disc the mean of exp(-s) is 2 (1 - (1 + x) exp(-x)) / x^2, x = 2 R.
TEST_P(TranslucentScenes, MeanTransmittanceOverASpheresDiscIsKnown) {
  for (const float extinction : {0.5f, 1.0f}) {
    const Scene scene = lit_alone(translucent(sphere_mesh(65), {glm::vec3(extinction)}), {0, 0, 1}, {0, 0, 60}, 2.1f);
    for (const std::string name : {"one_sample", "light_sums"}) {
      const Image image = picture(scene, name, 96);
      const double colour = diffuse_reflectance(stored_albedo(scene.objects[0]).g, 1), wrap = 0.25;
      double sum = 0, pixels = 0;
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
          const double half = 60 * std::tan(glm::radians(1.05)), px = ((x + 0.5) / 48 - 1) * half,
                       py = ((y + 0.5) / 48 - 1) * half;
          const double r2 = px * px + py * py;
          if (r2 > 0.97) continue;
          const double cosine = std::sqrt(1 - r2);
          sum += double(pixel(image, x, y).g) / (colour * (cosine + wrap) / ((1 + wrap) * (1 + wrap)));
          ++pixels;
        }
      // Without the rim: the integral from cosine sqrt(.03) to 1 of 2 c exp(-x c), over .97.
      const double x = 2 * double(extinction), low = std::sqrt(0.03);
      const auto inner = [x](double c) { return -2 * std::exp(-x * c) * (x * c + 1) / (x * x); };
      EXPECT_NEAR(sum / pixels, (inner(1) - inner(low)) / 0.97, 0.01) << name << " " << extinction;
    }
  }
}

// Lit all over from afar, pixel by pixel weighed by what it is of the sphere: what a wrap adds up to, over Lambert's.
TEST_P(TranslucentScenes, WrapsAddUpToTheirEnergy) {
  const double wrap = 0.25;
  const auto energy = [&](const std::string& name) {
    double sum = 0;
    constexpr int steps = 10;
    for (int i = 0; i < steps; ++i) {  // cosines spread evenly: each stands for the same area
      const double cosine = (i + 0.5) / steps * 2 - 1, sine = std::sqrt(1 - cosine * cosine);
      const Scene scene = lit_alone(translucent(block_mesh({{{-1, -1, -1}, {1, 0, 1}}}, 1), {.wrap = wrap}),
                                    {static_cast<float>(-sine), static_cast<float>(-cosine), 0}, {0, 4, 0.001f}, 1);
      sum += middle(picture(scene, name, 8)).g / diffuse_reflectance(stored_albedo(scene.objects[0]).g, 1) / steps;
    }
    return sum / 0.25;  // Lambert's mean over the sphere
  };
  EXPECT_NEAR(energy("wrap_printed"), 1 + wrap, 0.02);
  EXPECT_NEAR(energy("wrap_normalised"), 1, 0.02);
  EXPECT_NEAR(energy("wrap_table"), 1.2588, 0.02) << "green has no shift";
  // 1 + 4 (t - 0.4), t = 0.75 of a thickness map of 0.25; and half as much again of t' / 1.
  EXPECT_NEAR(energy("clement_printed"), 1 + 4 * 0.35, 0.02);
  EXPECT_NEAR(energy("clement_normalised"), 1 + 0.35 / 0.6, 0.02);
}

TEST_P(TranslucentScenes, EveryVariantIsFiniteWhateverTheMediumAndLights) {
  for (const auto& [eta, extinction] : {std::pair(1.0, 0.0f), {3.0, 1e9f}}) {
    Scene scene = lit_alone(translucent(shell_mesh(0.5f, 5), {glm::vec3(extinction), eta, 1, 0, {1, 0, 0.5f}}), {0, 0, -1},
                            {0, 0.5f, 3}, 40);
    Light lamp;
    lamp.kind = Light::Kind::point;
    lamp.position = {0, 3, -2};
    lamp.casts = true;
    scene.lights.push_back(lamp);
    lamp.position = {0, 0, 0};  // inside, and so it cannot cast
    lamp.casts = false;
    scene.lights.push_back(lamp);
    for (const VariantManifest& candidate : library().effect("translucency").variants)
      EXPECT_EQ(nonfinite_pixels(picture(scene, candidate.name, 24)), 0u) << candidate.name << " " << extinction;
  }
}

TEST_P(TranslucentScenes, WithoutACastingLightNoMapIsDrawn) {
  Scene scene = lit_alone(translucent(sphere_mesh(9), {}), {0, 0, -1}, {0, 0, 5}, 26);
  scene.lights[0].casts = false;
  const double colour = diffuse_reflectance(stored_albedo(scene.objects[0]).g, 1);
  for (const std::string name : {"refracted_march", "one_sample", "light_sums", "filtered_samples"})
    EXPECT_NEAR(middle(picture(scene, name, size)).g, colour, 0.01 * colour) << name;
}

TEST_P(TranslucentScenes, SumsRefuseAnOpenMesh) {
  Scene scene = lit_alone(translucent(sphere_mesh(9), {}), {0, 0, -1}, {0, 0, 5}, 26);
  scene.objects[0].mesh.indices.resize(scene.objects[0].mesh.indices.size() - 3);
  try {
    picture(scene, "light_sums", size);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("light_sums needs a closed hull"), std::string::npos) << error.what();
  }
  EXPECT_EQ(nonfinite_pixels(picture(scene, "one_sample", size)), 0u);
}

INSTANTIATE_TEST_SUITE_P(Backends, TranslucentScenes, backend_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
