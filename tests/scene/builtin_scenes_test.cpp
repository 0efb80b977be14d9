// SPDX-License-Identifier: Apache-2.0
// What every scene made by code promises, and the closed forms of those that have them.
#include "harness/scene/made/builtin_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/scene/made/conical_pit.h"
#include "harness/scene/made/day.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/made/two_windows.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"
#include "tests/scene/rays.h"

namespace lamina {
namespace {

const Object& named(const Scene& scene, const std::string& name) {
  for (const Object& object : scene.objects)
    if (object.name == name) return object;
  throw std::runtime_error("no object " + name);
}

class BuiltinScene : public testing::TestWithParam<std::string> {};

TEST_P(BuiltinScene, IsSoundInEveryVertexAndTriangle) {
  const Scene scene = load_scene(GetParam(), builtin_library());
  EXPECT_EQ(scene.name, GetParam());
  EXPECT_EQ(scene.source, GetParam());
  // Cards of hair share the strands of one texture.
  const auto is_of_cards = [](const Object& object) { return object.name == "hair"; };
  if (std::ranges::none_of(scene.objects, is_of_cards)) {
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
  }
  for (const Object& object : scene.objects) {
    SCOPED_TRACE(object.name);
    EXPECT_TRUE(albedo_of(object));
    EXPECT_EQ(object.unwrap_problem, "");
    if (!is_of_cards(object)) {
      EXPECT_LE(overlap_fraction(object.mesh), 0.001);
    }
    const Mesh& mesh = object.mesh;
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    std::vector<bool> used(mesh.vertices.size());
    size_t out_of_range = 0, away = 0;
    for (const uint32_t index : mesh.indices)
      if (index < used.size())
        used[index] = true;
      else
        ++out_of_range;
    ASSERT_EQ(out_of_range, 0u);
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices that no triangle uses";
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                   &c = mesh.vertices[mesh.indices[i + 2]];
      away += glm::dot(glm::cross(b.position - a.position, c.position - a.position), a.normal + b.normal + c.normal) <= 0;
    }
    // The heart's sharpest folds have smooth normals: heart_test.cpp says how it is closed.
    if (object.name != "heart") {
      EXPECT_EQ(away, 0u) << "triangles that do not face where their normals point";
    }
    size_t bad_frames = 0, outside = 0;
    for (const Vertex& v : mesh.vertices) {
      const glm::vec3 tangent(v.tangent);
      bad_frames += !(std::abs(glm::length(v.normal) - 1) < 1e-4f && std::abs(glm::length(tangent) - 1) < 1e-4f &&
                      std::abs(glm::dot(v.normal, tangent)) < 1e-4f && std::abs(v.tangent.w) == 1);
      outside += !(v.uv.x >= 0 && v.uv.y >= 0 && v.uv.x <= 1 && v.uv.y <= 1);
    }
    EXPECT_EQ(bad_frames, 0u);
    EXPECT_EQ(outside, 0u) << "vertices outside the unit tile";
  }
  for (const Light& light : scene.lights) EXPECT_NEAR(glm::length(light.direction), 1.0f, 1e-5f) << light.name;
  EXPECT_GE(scene.views.size(), 2u);
}

TEST_P(BuiltinScene, RefusesATimeThatIsNone) {
  expect_refused([] { read_builtin(GetParam(), NAN); }, {GetParam(), "time"});
  expect_refused([] { read_builtin(GetParam(), INFINITY); }, {GetParam(), "time"});
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScene, testing::ValuesIn(builtin_scenes()), [](const auto& test) { return test.param; });

TEST(BuiltinScenes, AnUnknownNameIsRefusedWithTheNearest) {
  expect_refused([] { read_builtin("terain", 0); }, {"'terain'", "'terrain'"});
}

TEST(BuiltinScenes, AperturesWhereTheSceneIsMadeForThem) {
  for (const std::string name : {"terrain", "sphere_over_plane", "two_windows", "open_plane"})
    for (const Object& object : load_scene(name, builtin_library()).objects) {
      EXPECT_TRUE(has_apertures(object)) << name;
      EXPECT_FALSE(has_layers(object)) << name;
    }
  const Scene pit = load_scene("conical_pit", builtin_library());
  EXPECT_TRUE(has_apertures(named(pit, "floor")));
  EXPECT_FALSE(has_apertures(named(pit, "cone")));
}

TEST(Terrain, IsLitByTheDay) {
  for (const float time : {0.0f, 6.1f, 18.0f}) {
    const Scene scene = load_scene("terrain", builtin_library(), time);
    const Daylight day = daylight(time);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "sun");
    EXPECT_EQ(scene.lights[0].direction, -day.to_sun);
    EXPECT_EQ(scene.lights[0].radiance, day.radiance);
    EXPECT_FLOAT_EQ(scene.lights[0].angular_radius, glm::radians(day_sun_radius_degrees));
    EXPECT_EQ(scene.ambient, day.ambient);
    EXPECT_TRUE(scene.lights_move);
    EXPECT_EQ(scene.time_s, time);
  }
}

TEST(Terrain, ViewsStandAboveTheGround) {
  const Scene scene = load_scene("terrain", builtin_library());
  for (const View& view : scene.views) {
    EXPECT_TRUE(blocks(scene.objects[0], view.eye, {0, -1, 0})) << view.name;
    EXPECT_FALSE(blocks(scene.objects[0], view.eye, {0, 1, 0})) << view.name;
  }
}

TEST(ApertureLightingScenes, TheExampleFilesLoad) {
  const Scene noon = load_scene(LAMINA_SOURCE_DIR "/variants/aperture_lighting/scenes/terrain_noon.toml", builtin_library());
  EXPECT_EQ(noon.time_s, 6.1f);
  EXPECT_EQ(apertures_of(noon.objects.at(0)).numbers.at("rays"), 4096);
  EXPECT_LT(glm::distance(noon.lights.at(0).direction, -daylight(6.1f).to_sun), 0.01f) << "the sun of noon";
  EXPECT_NEAR(glm::degrees(noon.lights.at(0).angular_radius), 0.2665f, 1e-5f);
  const Scene model = load_scene(LAMINA_SOURCE_DIR "/variants/aperture_lighting/scenes/model.toml", builtin_library());
  for (const Object& object : model.objects) EXPECT_TRUE(has_apertures(object));
}

// From the floor's middle the sky begins at the rim, all around.
TEST(ConicalPit, TheRimIsSeenAtItsAngle) {
  const Scene scene = load_scene("conical_pit", builtin_library());
  for (int i = 0; i < 90; ++i) {
    const double around = 0.07 * i;
    const auto direction = [&](double degrees) {
      const double t = glm::radians(degrees);
      return glm::dvec3(std::sin(t) * std::cos(around), std::cos(t), std::sin(t) * std::sin(around));
    };
    EXPECT_FALSE(blocks(named(scene, "cone"), glm::dvec3(0), direction(pit_rim_degrees - 0.01))) << i;
    for (const double beyond : {0.01, 10.0, 39.9})
      EXPECT_TRUE(blocks(named(scene, "cone"), glm::dvec3(0), direction(pit_rim_degrees + beyond))) << i;
  }
  const Light& sun = scene.lights.at(0);
  const float zenith_degrees = glm::degrees(std::acos(-sun.direction.y)), radius_degrees = glm::degrees(sun.angular_radius);
  EXPECT_LT(zenith_degrees - radius_degrees, pit_rim_degrees);
  EXPECT_GT(zenith_degrees + radius_degrees, pit_rim_degrees);
}

TEST(OpenPlane, HidesNothingOfTheSky) {
  const Scene scene = load_scene("open_plane", builtin_library());
  EXPECT_NEAR(glm::degrees(scene.lights.at(0).angular_radius), 10.0f, 1e-4f);
  for (const Vertex& vertex : scene.objects.at(0).mesh.vertices) {
    EXPECT_EQ(vertex.position.y, 0.0f);
    EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
  }
}

TEST(SphereOverPlane, IsARoundBallAboveAFlatPlane) {
  const Scene scene = load_scene("sphere_over_plane", builtin_library());
  const Object& sphere = named(scene, "sphere");
  for (const Vertex& vertex : sphere.mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.position), 1.0f, 1e-5f);
    EXPECT_LT(glm::distance(vertex.position, vertex.normal), 1e-5f);
  }
  // The facets cut off little of the ball.
  EXPECT_NEAR(enclosed_volume(sphere.mesh), 4 * M_PI / 3, 0.01);
  EXPECT_GT(sphere.world_from_object[3].y, 1.0f) << "it hovers";
  EXPECT_LT(sphere.world_from_object[3].y, 1.5f);
  // Straight up from under the sphere there is no sky; along the plane there is.
  EXPECT_TRUE(blocks(sphere, {0.2, 0.001, 0}, {0, 1, 0}));
  EXPECT_FALSE(blocks(sphere, {0.2, 0.001, 0}, {1, 0.02, 0}));
}

// A ray leaves the room where it passes through one window's rectangle on both sides of the wall, and nowhere else.
TEST(TwoWindows, TheSkyIsSeenThroughTheWindowsAlone) {
  const Scene scene = load_scene("two_windows", builtin_library());
  const Object& room = named(scene, "room");
  const glm::dvec3 middle = glm::dvec3(room_low + room_high) / 2.0;
  const double wall = 0.24;
  Random random(1);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    // Half of them at the wall with the windows, half anywhere.
    const glm::dvec3 target = i % 2 ? glm::dvec3(-2.5 + 5 * random.next(), 2.7 * random.next(), 0)
                                    : middle + glm::dvec3(random.next(), random.next(), random.next()) - 0.5;
    const glm::dvec3 direction = glm::normalize(target - middle);
    bool free = false;
    double margin = 1;  // to the nearest edge of a window, where rounding decides
    for (int window = 0; window < 2 && direction.z < 0; ++window) {
      double inside = 1;
      for (const double z : {0.0, -wall}) {
        const glm::dvec2 p(middle + direction * ((z - middle.z) / direction.z));
        const glm::dvec2 low = p - glm::dvec2(window_low[window]), high = glm::dvec2(window_high[window]) - p;
        inside = std::min({inside, low.x, low.y, high.x, high.y});
      }
      free |= inside > 0;
      margin = std::min(margin, std::abs(inside));
    }
    if (margin < 1e-4) continue;
    seen += free;
    EXPECT_EQ(blocks(room, middle, direction), !free) << direction.x << " " << direction.y << " " << direction.z;
  }
  EXPECT_GT(seen, 20);
}

TEST(TwoWindows, TheWallsAreThick) {
  const Scene scene = load_scene("two_windows", builtin_library());
  const glm::dvec3 inside = room_high - room_low, outside = inside + 2 * 0.24;
  double holes = 0;
  for (int i = 0; i < 2; ++i) {
    const glm::dvec2 size = window_high[i] - window_low[i];
    holes += 0.24 * size.x * size.y;
  }
  const double solid = outside.x * outside.y * outside.z - inside.x * inside.y * inside.z - holes;
  EXPECT_NEAR(enclosed_volume(named(scene, "room").mesh), solid, 1e-4 * solid);
  size_t vertices = 0;
  for (const Object& object : scene.objects) vertices += object.mesh.vertices.size();
  EXPECT_LT(vertices, 60000u);
}

}  // namespace
}  // namespace lamina
