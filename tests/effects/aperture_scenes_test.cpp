// SPDX-License-Identifier: Apache-2.0
// Where the visible region is a circle (an open plane, the bottom of a conical pit), a picture lit through baked apertures
// agrees with one lit by traced visibility; and wherever, exact_cap computes what the double form says of the same apertures.
#include <gtest/gtest.h>

#include "harness/effects/aperture_lighting/aperture_baker.h"
#include "harness/effects/aperture_lighting/direct_light.h"
#include "harness/measure/rounds.h"
#include "harness/quality/quality.h"
#include "harness/scene/textures.h"
#include "tests/effects/made_scenes.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

class ApertureScenes : public EachBackend {
 protected:
  struct Pictures {
    Image device, exact, integrated, traced_share;
    Mask covered;
  };
  // Few rays for the large scenes: enough to be lit unevenly.
  static Scene small(const std::string& name) {
    Scene scene = load_scene(name, builtin_library());
    for (Object& object : scene.objects)
      if (object.mesh.vertices.size() > 500) apertures_of(object).numbers["rays"] = 64;
    return scene;
  }
  // View 0 by a variant; and by the models, over the covered pixels. `teller`: a variant with passes for the truth, if it has
  // none.
  Pictures pictures(const Scene& scene, Bakes& bakes, bool traced, const std::string& name = "exact_cap",
                    std::string teller = "") {
    if (teller.empty()) teller = name;
    constexpr uint32_t size = 64;
    const Plan plan = make_plan(library(), scene);
    ShaderCache shaders(backend_->info().api, library().shaders);
    SceneResources resources(*backend_, scene, library(), size, size, &bakes);
    const Configuration configuration = configuration_with(plan, variant(name));
    const Graph graph = make_graph(plan, configuration, scene, shaders),
                truth = make_graph(plan, configuration_with(plan, variant(teller)), scene, shaders, &variant(teller));
    Frame frame(resources, graph, Build::timed), told(resources, truth, Build::timed, TargetSharing::off);
    frame.run(0, Timing::off);
    told.run(0, Timing::off);
    const ApertureKind kind = aperture_kind(variant(name).bake);
    const std::map<std::string, Image> targets = told.targets_of(variant(teller));
    std::vector<Image> apertures;
    for (uint32_t i = 0; i < kind.count; ++i) apertures.push_back(targets.at(fmt::format("seen_aperture_{}", i)));
    const ShadingPoints points =
        shading_points(targets.at("seen_point"), targets.at("seen_normal"), targets.at("seen_albedo"), apertures, kind);
    EXPECT_GT(points.points.size(), size * size / 4) << "the view shows little of the effect";
    Pictures made{frame.picture(), frame.picture(), frame.picture(), frame.picture(), {points.width, points.height, {}}};
    made.covered.on.assign(made.device.rgba.size() / 4, 0);
    const auto light = [&](LightModel model, Image& into) {
      const auto lit = direct_light(points, scene, bakes.occluders(), model, {200, 200, 1, bakes.occluders().default_bias_m()},
                                    [](double) {});
      for (size_t i = 0; i < lit.size(); ++i) {
        made.covered.on[points.points[i].pixel] = 1;
        for (int c = 0; c < 3; ++c) into.rgba[4 * points.points[i].pixel + c] = lit[i][c];
      }
    };
    light(LightModel::exact_intersection, made.exact);
    if (teller != name) light(LightModel::integrated_cosine, made.integrated);
    if (traced) light(LightModel::traced_share, made.traced_share);
    return made;
  }
  static double psnr(const Image& a, const Image& b, const Mask& mask) { return psnr_db(to_display(a), to_display(b), &mask); }
};

TEST_P(ApertureScenes, ExactCapIsTheDoubleForm) {
  for (const std::string name : {"sphere_over_plane", "two_windows"}) {
    const Scene scene = small(name);
    Bakes bakes(scene, effect_code(), DiskCache(""));
    for (const std::string told : {"exact_cap", "two_apertures", "four_apertures", "anti_aperture"}) {
      const Pictures made = pictures(scene, bakes, false, told);
      EXPECT_EQ(nonfinite_pixels(made.device), 0u);
      EXPECT_GE(psnr(made.device, made.exact, made.covered), 55) << name << " " << told;
    }
  }
}

// The cosine over the shared area, in closed form, against the double form's sum over the area; the cosine at the middle of the
// two directions is far from it. Bounds as measured, less 1 dB or so: where the rim cuts a large light the middle of the shared
// line is no exact centroid, and the sum has 200 samples a light, too few for a small sun through small windows.
TEST_P(ApertureScenes, LensCosineIsTheCosineOverTheSharedArea) {
  for (const auto& [name, min_db] : {std::pair("sphere_over_plane", 40.0), {"conical_pit", 35.0}}) {
    const Scene scene = small(name);
    Bakes bakes(scene, effect_code(), DiskCache(""));
    const Pictures lens = pictures(scene, bakes, false, "exact_lens_cosine", "exact_cap");
    const double near_db = psnr(lens.device, lens.integrated, lens.covered),
                 middle_db = psnr(lens.exact, lens.integrated, lens.covered);
    EXPECT_GE(near_db, min_db) << name;
    EXPECT_GE(near_db, middle_db + 6) << name;
  }
}

TEST_P(ApertureScenes, MapsAndPointLightsAreTheDoubleFormToo) {
  Scene scene = load_scene("conical_pit", builtin_library());
  apertures_of(scene.objects[0]).numbers["map_texels"] = 64;
  Light lamp;
  lamp.kind = Light::Kind::point;
  lamp.position = scene.objects[0].mesh.vertices[0].position + glm::vec3(0.45f, 0.4f, 0);  // cut by the rim
  lamp.radius_m = 0.2f;
  lamp.radiance = glm::vec3(0.5f);
  scene.lights.push_back(lamp);
  Bakes bakes(scene, effect_code(), DiskCache(""));
  const Pictures made = pictures(scene, bakes, false);
  EXPECT_GE(psnr(made.device, made.exact, made.covered), 55);
}

TEST_P(ApertureScenes, OpenPlaneAgreesWithTracedVisibility) {
  const Scene scene = load_scene("open_plane", builtin_library());
  Bakes bakes(scene, effect_code(), DiskCache(""));
  const Pictures made = pictures(scene, bakes, true);
  EXPECT_GE(psnr(made.device, made.traced_share, made.covered), 40);
}

TEST_P(ApertureScenes, ConicalPitAgreesWithTracedVisibility) {
  const Scene scene = load_scene("conical_pit", builtin_library());
  Bakes bakes(scene, effect_code(), DiskCache(""));
  const Pictures made = pictures(scene, bakes, true);
  EXPECT_GE(psnr(made.device, made.traced_share, made.covered), 40);
}

// Normals without length, triangles without area, vertices that nothing uses; lights that are points, hemispheres, below the
// horizon, around the eye of a point.
TEST_P(ApertureScenes, EveryVariantIsFiniteWhateverTheMeshAndLights) {
  Scene scene = scene_of({quad("floor", {-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}), ring("lid", 0, 0.5f, 0.5f, 0.5f, 16)});
  for (Object& object : scene.objects) {
    apertures_of(object);
    object.effects["surface"].textures["albedo"] = constant_texture("white", glm::vec4(1), TexelMeaning::colour);
  }
  Mesh& mesh = scene.objects[0].mesh;
  for (Vertex& vertex : mesh.vertices) vertex.normal = glm::vec3(0);
  mesh.vertices.push_back(vertex_at({9, 9, 9}, {0, 0, 0}));
  mesh.indices.insert(mesh.indices.end(), {1, 1, 1, 0, 1, 1});
  for (const glm::vec3 direction : {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)})
    for (const float radius : {0.0f, std::numbers::pi_v<float> / 2}) {
      Light light;
      light.direction = direction;
      light.angular_radius = radius;
      scene.lights.push_back(light);
    }
  Light around;
  around.kind = Light::Kind::point;
  around.radius_m = 0.3f;
  scene.lights.push_back(around);
  scene.ambient = glm::vec3(0.2f);
  scene.views = {{"above", {0, 2, 1}, {0, 0, 0}, {0, 1, 0}, 60, 0.1f, 10}};
  for (const uint32_t map_texels : {0u, 16u}) {
    apertures_of(scene.objects[0]).numbers["map_texels"] = map_texels;
    for (const VariantManifest& candidate : library().effect("aperture_lighting").variants)
      EXPECT_EQ(nonfinite_pixels(picture(scene, candidate.name, 32)), 0u) << candidate.name << " " << map_texels;
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, ApertureScenes, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
