// SPDX-License-Identifier: Apache-2.0
// Where the visible region is a circle (an open plane, the bottom of a conical pit), a picture lit through baked apertures
// agrees with one lit by traced visibility; and wherever, exact_cap computes what the double form says of the same apertures.
#include <gtest/gtest.h>

#include "harness/measure/rounds.h"
#include "harness/quality/quality.h"
#include "harness/truth/direct_light.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

class ApertureScenes : public EachBackend {
 protected:
  struct Pictures {
    Image device, exact, traced_share;
    Mask covered;
  };
  // View 0 by exact_cap; and by the models, over the covered pixels.
  Pictures pictures(const std::string& name, uint32_t size) {
    Scene scene = load_scene(name);
    for (Object& object : scene.objects)
      if (object.mesh.vertices.size() > 5000) object.apertures->rays = 64;  // enough to be lit unevenly
    const Plan plan = make_plan(library(), scene);
    ShaderCache shaders(backend_->info().api, library().shaders);
    Bakes bakes(scene, DiskCache(""));
    SceneResources resources(*backend_, scene, size, size, &bakes);
    const Configuration configuration = configuration_with(plan, variant("exact_cap"));
    const Graph graph = make_graph(plan, configuration, scene, shaders),
                truth = make_graph(plan, configuration, scene, shaders, Purpose::truth);
    Frame frame(resources, graph, Build::timed), told(resources, truth, Build::timed);
    frame.run(0, Timing::off);
    told.run(0, Timing::off);
    const ShadingPoints points = shading_points(told.target("seen_point"), told.target("seen_normal"),
                                                told.target("seen_albedo"), {told.target("seen_aperture_0")}, {});
    EXPECT_GT(points.points.size(), size * size / 4) << "the view shows little of the effect";
    Pictures made{frame.picture(), frame.picture(), frame.picture(), {points.width, points.height, {}}};
    made.covered.on.assign(made.device.rgba.size() / 4, 0);
    const auto light = [&](LightModel model, Image& into) {
      const auto lit = direct_light(points, scene, bakes.occluders(), model, {400, 400, 1, bakes.occluders().default_bias_m()},
                                    [](double) {});
      for (size_t i = 0; i < lit.size(); ++i) {
        made.covered.on[points.points[i].pixel] = 1;
        for (int c = 0; c < 3; ++c) into.rgba[4 * points.points[i].pixel + c] = lit[i][c];
      }
    };
    light(LightModel::exact_intersection, made.exact);
    light(LightModel::traced_share, made.traced_share);
    return made;
  }
  static double psnr(const Image& a, const Image& b, const Mask& mask) { return psnr_db(to_display(a), to_display(b), &mask); }
};

TEST_P(ApertureScenes, ExactCapIsTheDoubleForm) {
  for (const std::string name : {"sphere_over_plane", "two_windows"}) {
    const Pictures made = pictures(name, 64);
    EXPECT_EQ(nonfinite_pixels(made.device), 0u);
    EXPECT_GE(psnr(made.device, made.exact, made.covered), 55) << name;
  }
}

TEST_P(ApertureScenes, OpenPlaneAgreesWithTracedVisibility) {
  const Pictures made = pictures("open_plane", 64);
  EXPECT_GE(psnr(made.device, made.traced_share, made.covered), 40);
}

TEST_P(ApertureScenes, ConicalPitAgreesWithTracedVisibility) {
  const Pictures made = pictures("conical_pit", 64);
  EXPECT_GE(psnr(made.device, made.traced_share, made.covered), 40);
}

INSTANTIATE_TEST_SUITE_P(Backends, ApertureScenes, backend_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
