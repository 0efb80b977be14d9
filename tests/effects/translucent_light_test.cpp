// SPDX-License-Identifier: Apache-2.0
// The truth's parts against closed forms and published values: Fresnel and Snell, chords, path lengths through holes, single
// scattering in a slab, and the random walk.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <numbers>

#include "harness/effects/translucency/random_walk.h"
#include "tests/effects/translucent_scenes.h"

namespace lamina {
namespace {

using std::numbers::pi;

double cosine_of(double degrees) { return std::cos(degrees * pi / 180); }

Scene slab_scene(const MediumNumbers& said, float thickness, float half_width) {
  return lit_alone(
      translucent(block_mesh({{{-half_width, -thickness, -half_width}, {half_width, 0, half_width}}}, half_width), said),
      {0, -1, 0}, {0, 3, 0}, 40);
}

TEST(TranslucentLight, FresnelIsTheTable) {
  const double degrees[] = {0, 45, 60, 75, 85};
  const double passed[3][5] = {{.982987, .976183, .946600, .798664, .426004},
                               {.972222, .963421, .928023, .768717, .401678},
                               {.960000, .949760, .910813, .746939, .387200}};
  const double indices[] = {1.3, 1.4, 1.5};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(1 - fresnel_reflectance(cosine_of(degrees[k]), indices[i]), passed[i][k], 1e-6);
  EXPECT_EQ(fresnel_reflectance(0, 1.4), 1);
  EXPECT_NEAR(fresnel_reflectance(0.3, 1), 0, 1e-15);
  EXPECT_EQ(fresnel_reflectance(0, 1), 0);
}

TEST(TranslucentLight, MeanFresnelIsTheTable) {
  for (const auto& [eta, outside] : {std::pair(1.3, .061132), {1.33, .065931}, {1.4, .076812}, {1.5, .091778}}) {
    const auto weighed = [eta = eta](double u) { return fresnel_reflectance(std::sqrt(u), eta); };
    EXPECT_NEAR((boost::math::quadrature::gauss<double, 60>::integrate(weighed, 0.0, 1.0)), outside, 5e-6) << eta;
  }
}

TEST(TranslucentLight, DiffuseReflectanceIsJensens) {
  const double scattering[] = {.74, .88, 1.01}, absorption[] = {.032, .17, .48}, skin[] = {.435956, .227331, .130999};
  // The table is of eta 1.3.
  for (int c = 0; c < 3; ++c) {
    const double albedo = scattering[c] / (scattering[c] + absorption[c]);
    EXPECT_NEAR(diffuse_reflectance(albedo, 1.3), skin[c], 2e-4);
  }
}

// 2 R cos t', where sin t' = sin t / eta.
TEST(TranslucentLight, ChordsOfASphereAreRefracted) {
  const double degrees[] = {0, 30, 60, 80};
  const double chords[4][4] = {{2, 1.732051, 1, .347296},
                               {2, 1.846154, 1.491594, 1.305567},
                               {2, 1.868100, 1.571429, 1.421521},
                               {2, 1.885618, 1.632993, 1.508585}};
  const double indices[] = {1, 1.3, 1.4, 1.5};
  const Scene scene = lit_alone(translucent(sphere_mesh(97), {}), {0, -1, 0}, {0, 0, 4}, 40);
  const Solids solids(scene);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) {
      const double t = degrees[k] * pi / 180;
      const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, 0.2)), side = glm::normalize(glm::cross(normal, {0, 0, 1}));
      const glm::dvec3 inside = refracted_into(-std::cos(t) * normal + std::sin(t) * side, normal, indices[i]);
      const auto out = solids.way_out(normal * 0.9995, inside, 0);
      ASSERT_TRUE(out);
      EXPECT_NEAR(out->distance, chords[i][k], 4e-3) << indices[i] << " " << degrees[k];
    }
}

TEST(TranslucentLight, HolesDoNotCount) {
  for (const float hole : {0.0f, 0.8f}) {
    const Scene scene = lit_alone(translucent(hole > 0 ? shell_mesh(hole) : sphere_mesh(), {}), {0, -1, 0}, {0, 0, 4}, 40);
    const Solids solids(scene);
    const LightPath path = light_path(solids, {0, -0.9999, 0}, {0, -1, 0}, 0, scene.lights[0], Refraction::flat);
    EXPECT_NEAR(path.optical_depth.r, hole > 0 ? 0.4 : 2.0, 2e-3);
    EXPECT_NEAR(path.share, 1, 1e-6);
  }
}

// A flat surface refracts a parallel beam by the flat form, which the solved one must find.
TEST(TranslucentLight, SolvedRefractionIsTheFlatOneUnderAPlane) {
  Scene scene = slab_scene({.refraction_index = 1.4}, 1, 20);
  scene.lights[0].direction = glm::normalize(glm::vec3(0.8f, -1, 0.3f));
  const Solids solids(scene);
  const LightPath flat = light_path(solids, {0, -0.6, 0}, {0, 1, 0}, 0, scene.lights[0], Refraction::flat),
                  solved = light_path(solids, {0, -0.6, 0}, {0, 1, 0}, 0, scene.lights[0], Refraction::solved);
  const double cosine = 1 / std::sqrt(1.73), inside = std::sqrt(1 - (1 - cosine * cosine) / 1.96);
  EXPECT_NEAR(flat.optical_depth.r, 0.6 / inside, 1e-4);
  EXPECT_NEAR(solved.optical_depth.r, 0.6 / inside, 1e-3);
  EXPECT_NEAR(flat.share, (1 - fresnel_reflectance(cosine, 1.4)) * cosine / inside, 1e-6);
  EXPECT_NEAR(solved.share, flat.share, 1e-3);
}

// Near the axis a sphere of index eta is a lens: a beam has narrowed, at depth s below its pole, by 1 - s (1 - 1 / eta) / R.
TEST(TranslucentLight, ASphereGathersLight) {
  const Scene scene = lit_alone(translucent(sphere_mesh(97), {.refraction_index = 1.5}), {0, -1, 0}, {0, 0, 4}, 40);
  const Solids solids(scene);
  for (const double depth : {0.5, 1.0, 1.6}) {
    const LightPath path = light_path(solids, {0, 1 - depth, 0}, {0, 1, 0}, 0, scene.lights[0], Refraction::solved);
    const double narrower = 1 - depth / 3;
    EXPECT_NEAR(path.share, 0.96 / (narrower * narrower), 0.03 * path.share) << depth;
    EXPECT_NEAR(path.optical_depth.r, depth, 3e-3);
  }
}

// Hanrahan and Krueger 1993: albedo .9585, no refraction.
TEST(TranslucentLight, SingleScatteringOfASlabIsTheClosedForm) {
  const double radiance[2][2] = {{.03297785, .03744091}, {.05790605, .05866599}};
  for (int k = 0; k < 2; ++k) {
    const double mu = k == 0 ? 1 : 0.3;
    for (int tau = 1; tau <= 2; ++tau) {
      const Scene scene = slab_scene({}, static_cast<float>(tau), 60);
      const Solids solids(scene);
      const LitPoint point{0, {0, 0, 0}, {0, 1, 0}, {std::sqrt(1 - mu * mu), mu, 0}, glm::dvec3(.9585)};
      EXPECT_NEAR(single_scattering(solids, scene, point, Refraction::flat).r / pi, radiance[k][tau - 1], 2e-4);
    }
  }
}

// Skin of Jensen and others (SIGGRAPH 2001), 1 mm thick, lit along the normal: shares of all light, of which the surface
// reflects some before it enters.
TEST(TranslucentLight, RandomWalkThroughASlabIsKnown) {
  const glm::dvec3 scattering(.74, .88, 1.01), absorption(.032, .17, .48);
  const glm::dvec3 passed[2] = {{.693, .542, .342}, {.647, .470, .286}}, back[2] = {{.260, .238, .179}, {.225, .154, .093}};
  for (int i = 0; i < 2; ++i) {
    const Scene scene = slab_scene({glm::vec3(scattering + absorption), i == 0 ? 1.0 : 1.4}, 1, 300);
    const Solids solids(scene);
    const double entered = 1 - fresnel_reflectance(1, i == 0 ? 1.0 : 1.4);
    WalkRandom random(1);
    constexpr int walks = 150000;
    glm::dvec3 through(0), returned(0);
    for (int walk = 0; walk < walks; ++walk) {
      const WalkEnd end = random_walk(solids, 0, scattering / (scattering + absorption), {0, -1e-4, 0}, {0, -1, 0}, random,
                                      [](glm::dvec3, glm::dvec3, int) {});
      if (end.left) (end.position.y < -0.5 ? through : returned) += end.weight * (entered / walks);
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(through[c], passed[i][c], 0.006) << i << c;
      EXPECT_NEAR(returned[c], back[i][c], 0.006) << i << c;
    }
  }
}

// What is scattered at all, over all outgoing directions, is what a walk of the eye's finds: reciprocity, without refraction.
TEST(TranslucentLight, MultipleScatteringAddsUpToTheSlabsReflectance) {
  const Scene scene = slab_scene({.multiple_scattering = 1}, 30, 600);
  const Solids solids(scene);
  double all = 0;
  constexpr int angles = 24;
  for (int i = 0; i < angles; ++i) {
    const double mu = std::sqrt((i + 0.5) / angles);
    const LitPoint point{0, {0, 0, 0}, {0, 1, 0}, {std::sqrt(1 - mu * mu), mu, 0}, glm::dvec3(.9)};
    all +=
        (single_scattering(solids, scene, point, Refraction::flat) + multiple_scattering(solids, scene, point, 300, 7 + i)).g;
  }
  // 1 - sqrt(1 - a) H(1), Chandrasekhar, a = 0.9: H(1) = 2.0128.
  const double a = 0.9, integral = boost::math::quadrature::gauss<double, 200>::integrate(
                            [&](double x) {
                              const double t = x / (1 - x);
                              return std::log(1 - a * std::atan(t) / t) / (1 + t * t) / ((1 - x) * (1 - x));
                            },
                            1e-9, 1 - 1e-9);
  EXPECT_NEAR(all / angles, 1 - std::sqrt(1 - a) * std::exp(-integral / pi), 0.025);
}

}  // namespace
}  // namespace lamina
