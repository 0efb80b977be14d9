// SPDX-License-Identifier: Apache-2.0
// Pictures of light through objects against closed forms, on every backend.
#include "tests/effects/translucent_scenes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "harness/graph/views.h"
#include "tests/effects/backends_agree.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

class TranslucentScenes : public EachBackend {
 protected:
  static constexpr uint32_t size = 48;

  // Passes that draw what a light sees, and samplers that read what they draw.
  struct MapPasses {
    size_t passes = 0, once = 0, every_frame = 0, read = 0;  // once and every_frame: one a light
    std::set<std::string> left_out;                          // why
  };
  MapPasses map_passes(const Scene& scene, std::string_view name) {
    const Plan plan = make_plan(library(), scene, 1);
    ShaderCache shaders(backend_->info().api, library().shaders);
    const Graph graph = make_graph(plan, configuration_with(plan, variant(name)), scene, shaders);
    MapPasses found;
    for (const GraphPass& pass : graph.passes) {
      if (pass.pass->view == PassView::light) (pass.once ? found.once : found.every_frame) += pass.draws.size(), ++found.passes;
      for (const GraphDraw& draw : pass.draws)
        for (const ResolvedRead& read : draw.reads) found.read += read.source.light.has_value();
    }
    for (const GraphPass& pass : graph.dropped)
      if (pass.pass->view == PassView::light) found.left_out.insert(pass.reason);
    return found;
  }

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

// Whatever the free path: down to a millionth of the digits that places have. Of a light's lamp nearby too.
TEST_P(TranslucentScenes, TheMarchOfADenseMediumIsTheClosedForm) {
  const Mesh mesh = block_mesh({{{-2, -2, -2}, {2, 0, 2}}}, 2);
  for (const float extinction : {1e3f, 1e6f, 1e9f})
    for (const float slant : {0.0f, 0.8f}) {
      const Scene scene = lit_alone(translucent(mesh, {.extinction = glm::vec3(extinction), .albedo = glm::vec3(0.95f)}),
                                    {slant, -1, 0.3f * slant}, {2.4f, 3.2f, 0.001f}, 1);
      const double albedo = stored_albedo(scene.objects[0]).g, sun = -double(scene.lights[0].direction.y), eye = 0.8;
      const double expected = albedo / 4 * sun / (sun + eye);
      EXPECT_NEAR(middle(picture(scene, "refracted_march", size)).g, expected, 0.015 * expected) << extinction << " " << slant;
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

// A hollow ball under a lamp and the sun, both of which cast, and a light from the eye's side that does not.
TEST(TranslucentBackends, AgreeAndHaveNoNaN) {
  Scene scene = lit_alone(translucent(shell_mesh(0.5f, 17), {{0.7f, 1.5f, 3}, 1.4, 1, 0.25, {0.9f, 0.8f, 0.6f}}),
                          {0.3f, -0.5f, 1}, {0, 0.5f, 3.5f}, 40);
  Light lamp;
  lamp.kind = Light::Kind::point;
  lamp.position = {2, 3, -2};
  lamp.radiance = glm::vec3(8);
  lamp.casts = true;
  scene.lights.push_back(lamp);
  lamp.position = {0, 2, 4}, lamp.radiance = glm::vec3(1), lamp.casts = false;
  scene.lights.push_back(lamp);
  expect_backends_agree("translucency", {scene});
}

// In the variants that draw maps of the lights.
constexpr const char* mapped_variants[] = {"refracted_march", "burley_slab",     "filtered_samples",
                                           "one_sample",      "one_sample_ramp", "light_sums"};

TEST_P(TranslucentScenes, WithoutACastingLightNoMapIsDrawn) {
  Scene scene = lit_alone(translucent(sphere_mesh(9), {}), {0, 0, -1}, {0, 0, 5}, 26);
  scene.lights[0].casts = false;
  const double colour = diffuse_reflectance(stored_albedo(scene.objects[0]).g, 1);
  for (const std::string name : {"refracted_march", "one_sample", "light_sums", "filtered_samples"})
    EXPECT_NEAR(middle(picture(scene, name, size)).g, colour, 0.01 * colour) << name;
  for (const char* name : mapped_variants) {
    const MapPasses maps = map_passes(scene, name);
    EXPECT_EQ(maps.once + maps.every_frame, 0u) << name;
    EXPECT_EQ(maps.left_out, (std::set<std::string>{"no light casts"})) << name;
    EXPECT_EQ(maps.read, 0u) << name;
  }
}

// Each map is drawn once, one for a light, where nothing moves.
TEST_P(TranslucentScenes, StillLightsAndMeshesMakeOneMapALight) {
  Scene scene = lit_alone(translucent(sphere_mesh(9), {}), {0, 0, -1}, {0, 0, 5}, 26);
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].direction = {0, -1, 0};
  for (const char* name : mapped_variants) {
    scene.mesh_moves = scene.lights_move = false;
    const MapPasses still = map_passes(scene, name);
    EXPECT_EQ(still.every_frame, 0u) << name;
    EXPECT_EQ(still.once, 2 * still.passes) << name << ": one a light";
    EXPECT_GE(still.passes, 1u) << name;
    for (bool* moves : {&scene.mesh_moves, &scene.lights_move}) {
      scene.mesh_moves = scene.lights_move = false;
      *moves = true;
      EXPECT_EQ(map_passes(scene, name).once, 0u) << name;
      EXPECT_EQ(map_passes(scene, name).every_frame, 2 * still.passes) << name;
    }
  }
}

// A medium that scatters nothing sends nothing back, and asks for no map.
TEST_P(TranslucentScenes, ABlackMediumIsBlackWithoutAMap) {
  const Scene scene =
      lit_alone(translucent(sphere_mesh(9), {.refraction_index = 1.4, .multiple_scattering = 1, .albedo = {0, 0, 0}}),
                {0, 0, -1}, {0, 0, 5}, 26);
  for (const char* name : mapped_variants) {
    const MapPasses maps = map_passes(scene, name);
    EXPECT_EQ(maps.once + maps.every_frame + maps.read, 0u) << name;
    EXPECT_EQ(maps.left_out, (std::set<std::string>{"left out: nothing reads what it writes"})) << name;
    EXPECT_EQ(middle(picture(scene, name, 8)), glm::dvec3(0)) << name;
  }
}

// Through what is opaque nothing comes. Its map stays: with it an object still casts its shadow.
TEST_P(TranslucentScenes, NothingComesThroughWhatIsOpaque) {
  const Mesh block = block_mesh({{{-1, -1, -1}, {1, 0, 1}}, {{-1, -3, -1}, {1, -2, 1}}}, 1);
  for (const char* name : mapped_variants) {
    const auto seen = [&](glm::vec3 eye, glm::vec3 target) {
      Scene scene = lit_alone(translucent(block, {glm::vec3(1e9f), 1.4, 1, 0.25, glm::vec3(0.8f)}), {0, -1, 0}, eye, 2, target);
      return middle(picture(scene, name, 8)).g;
    };
    if (std::string(name) == "one_sample_ramp") continue;  // an artist's ramp knows no extinction
    EXPECT_EQ(seen({0, -9, 0.01f}, {0, -3, 0}), 0) << name << ": from below";
    EXPECT_EQ(seen({0, -1.2f, 5}, {0, -2, 0.3f}), 0) << name << ": in the shadow of the upper half";
    EXPECT_GT(seen({0, 9, 0.01f}, {0, 0, 0}), 0.15) << name << ": lit";
  }
}

// No object is out of the view of a light that casts: views of lights are fitted to all objects.
TEST(TranslucentLights, EveryCastingLightSeesEveryObject) {
  Scene scene = lit_alone(translucent(sphere_mesh(9), {}), {0.3f, -1, 0.2f}, {0, 0, 5}, 26);
  for (const glm::vec3 place : {glm::vec3(40, 3, -7), {-3, -60, 2}}) {
    scene.objects.push_back(translucent(sphere_mesh(9), {}));
    scene.objects.back().world_from_object[3] = glm::vec4(place, 1);
  }
  Light lamp;
  lamp.kind = Light::Kind::point;
  lamp.position = {70, 40, 3};
  scene.lights.push_back(lamp);
  for (const Light& light : scene.lights) {
    const glm::mat4 clip_from_world = light_view(light, bounding_sphere(scene.objects)).value().clip_from_world();
    for (const Object& object : scene.objects)
      for (const Vertex& vertex : object.mesh.vertices) {
        const glm::vec4 clip = clip_from_world * object.world_from_object * glm::vec4(vertex.position, 1);
        ASSERT_LE(std::max({std::abs(clip.x), std::abs(clip.y), clip.z}), clip.w);
        ASSERT_GE(clip.z, 0);
      }
  }
}

// By name, while the others go on.
TEST_P(TranslucentScenes, VariantsRefuseWhatTheyCannotDo) {
  const auto refused = [&](const Scene& scene, const char* name, const std::string& why) {
    try {
      picture(scene, name, 8);
      ADD_FAILURE() << name << ": nothing was thrown";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
    EXPECT_EQ(nonfinite_pixels(picture(scene, "wrap_normalised", 8)), 0u);
  };
  const Scene whole = lit_alone(translucent(sphere_mesh(9), {}), {0, 0, -1}, {0, 0, 5}, 26);
  Scene open = whole;
  open.objects[0].mesh.indices.resize(open.objects[0].mesh.indices.size() - 3);
  refused(open, "light_sums", "light_sums needs a closed hull, and its mesh is open: the edge from (");
  refused(open, "baked_thickness", "has no thickness: it needs a closed hull, and its mesh is open: the edge from (");
  Scene without_unwrap = whole;
  without_unwrap.objects[0].effects.at("translucency").numbers["thickness_texels"] = 32;
  without_unwrap.objects[0].unwrap_problem = "texture coordinates span 3 tiles";
  refused(without_unwrap, "baked_thickness",
          "needs an unwrap of its own: texture coordinates span 3 tiles; bake a point a vertex");
  Scene inside = whole;
  inside.lights[0].kind = Light::Kind::point;
  inside.lights[0].position = {0.2f, 0, 0};
  refused(inside, "one_sample", "light 'lamp' stands among the objects");
}

INSTANTIATE_TEST_SUITE_P(Backends, TranslucentScenes, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
