// SPDX-License-Identifier: Apache-2.0
// The built-in heart, held to what it promises: a closed surface with a unique unwrap, textures without seams, and a beat.
#include "harness/scene/made/heart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "harness/core/error.h"
#include "harness/scene/facts.h"
#include "tests/scene/declared.h"

namespace lamina {
namespace {

constexpr float period_s = 0.9f;

// With what its keys give it.
Scene heart(float time_s, uint32_t texture_size) {
  Scene scene = make_heart({.time_s = time_s, .texture_size = texture_size});
  declare_objects(scene.objects, builtin_library());
  for (Object& object : scene.objects) settle_facts(object, builtin_library().effect("layered_material"));
  return scene;
}
const Scene& expanded() {
  static const Scene scene = heart(0, 256);
  return scene;
}
// The middle of the hold, a third of the way through a beat.
const Scene& contracted() {
  static const Scene scene = heart(period_s / 3, 256);
  return scene;
}
const Mesh& mesh_of(const Scene& scene) { return scene.objects.at(0).mesh; }
const Texture& texture_of(const Scene& scene, const std::string& name) {
  return layers_of(scene.objects.at(0)).textures.at(name);
}

std::array<Vertex, 3> triangle(const Mesh& mesh, size_t first) {
  return {mesh.vertices[mesh.indices[first]], mesh.vertices[mesh.indices[first + 1]], mesh.vertices[mesh.indices[first + 2]]};
}

// By the divergence theorem: the sum of signed tetrahedra under the triangles, positive where they face outwards.
double signed_volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto t = triangle(mesh, i);
    six_volumes += glm::dot(glm::dvec3(t[0].position), glm::cross(glm::dvec3(t[1].position), glm::dvec3(t[2].position)));
  }
  return six_volumes / 6;
}

using Place = std::tuple<float, float, float>;
Place place_of(const Vertex& v) { return {v.position.x, v.position.y, v.position.z}; }

// Vertices by place, of the places that more than one vertex shares.
std::vector<std::vector<Vertex>> seam_vertices(const Mesh& mesh) {
  std::map<Place, std::vector<Vertex>> by_place;
  for (const Vertex& v : mesh.vertices) by_place[place_of(v)].push_back(v);
  std::vector<std::vector<Vertex>> shared;
  for (auto& [place, vertices] : by_place)
    if (vertices.size() > 1) shared.push_back(std::move(vertices));
  return shared;
}

// Bilinear, of the base level, as stored (no decoding), 0 to 1.
glm::vec4 sample(const TextureImage& texture, glm::vec2 uv) {
  const glm::vec2 p = uv * glm::vec2(texture.width, texture.height) - 0.5f, low = glm::floor(p), t = p - low;
  const auto texel = [&](int dx, int dy) {
    const size_t i =
        static_cast<size_t>(static_cast<int>(low.y) + dy) * texture.width + static_cast<size_t>(static_cast<int>(low.x) + dx);
    glm::vec4 value;
    for (int c = 0; c < 4; ++c)
      value[c] = static_cast<float>(std::to_integer<int>(texture.levels[0][4 * i + static_cast<size_t>(c)])) / 255;
    return value;
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y);
}

TEST(Heart, UnwrapCoversNoTexelTwiceAndKeepsAMargin) {
  constexpr int size = 1024;
  const float margin = 8.0f / size;
  std::vector<uint8_t> covered(size_t{size} * size, 0);
  const Mesh& mesh = mesh_of(expanded());
  size_t total = 0, twice = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto t = triangle(mesh, i);
    std::array<glm::dvec2, 3> p;
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(t[k].uv.x >= margin && t[k].uv.x <= 1 - margin && t[k].uv.y >= margin && t[k].uv.y <= 1 - margin);
      p[k] = glm::dvec2(t[k].uv) * double{size};
    }
    const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double area = side(p[0], p[1], p[2]);
    ASSERT_NE(area, 0) << "triangle " << i / 3;
    const glm::dvec2 low = glm::floor(glm::min(p[0], glm::min(p[1], p[2]))),
                     high = glm::ceil(glm::max(p[0], glm::max(p[1], p[2])));
    for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y)
      for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
        const glm::dvec2 center(x + 0.5, y + 0.5);
        // Strictly inside: a centre on an edge belongs to neither side here.
        bool inside = true;
        for (size_t k = 0; k < 3; ++k) inside = inside && side(p[k], p[(k + 1) % 3], center) / area > 1e-9;
        if (!inside) continue;
        ++total;
        if (covered[static_cast<size_t>(y) * size + static_cast<size_t>(x)]++ != 0) ++twice;
      }
  }
  EXPECT_EQ(twice, 0u);
  EXPECT_GT(total, size_t{size} * size * 3 / 4) << "most of the texture is used";
}

TEST(Heart, TexelsAreOfSimilarSizeOnTheSurface) {
  std::vector<double> ratios;  // area on the surface over area in the texture
  const Mesh& mesh = mesh_of(expanded());
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto t = triangle(mesh, i);
    const glm::vec2 a = t[1].uv - t[0].uv, b = t[2].uv - t[0].uv;
    ratios.push_back(glm::length(glm::cross(t[1].position - t[0].position, t[2].position - t[0].position)) /
                     std::abs(a.x * b.y - a.y * b.x));
  }
  std::sort(ratios.begin(), ratios.end());
  // Nine tenths of the triangles: edges of texels differ by a factor of less than five.
  EXPECT_LT(ratios[ratios.size() * 95 / 100] / ratios[ratios.size() * 5 / 100], 25);
}

TEST(Heart, FramesAreUnitOrthogonalAndFollowTheUnwrap) {
  for (const Scene* scene : {&expanded(), &contracted()}) {
    const Mesh& mesh = mesh_of(*scene);
    for (const Vertex& v : mesh.vertices) {
      ASSERT_TRUE(std::isfinite(v.position.x) && std::isfinite(v.position.y) && std::isfinite(v.position.z));
      ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
      ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-5);
      ASSERT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0, 1e-4);
      ASSERT_EQ(std::abs(v.tangent.w), 1);
    }
    // Against the derivatives of each triangle: P = P0 + du dP/du + dv dP/dv. A few triangles fold in tight corners.
    size_t along_u = 0, along_v = 0, outwards = 0, count = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3, ++count) {
      const auto t = triangle(mesh, i);
      const glm::vec3 e1 = t[1].position - t[0].position, e2 = t[2].position - t[0].position;
      const glm::vec2 a = t[1].uv - t[0].uv, b = t[2].uv - t[0].uv;
      const float det = a.x * b.y - a.y * b.x;
      const glm::vec3 dp_du = (e1 * b.y - e2 * a.y) / det, dp_dv = (e2 * a.x - e1 * b.x) / det;
      along_u += glm::dot(dp_du, glm::vec3(t[0].tangent)) > 0;
      along_v += glm::dot(dp_dv, t[0].tangent.w * glm::cross(t[0].normal, glm::vec3(t[0].tangent))) > 0;
      outwards += glm::dot(glm::cross(e1, e2), t[0].normal) > 0;
    }
    EXPECT_GT(static_cast<double>(along_u), 0.99 * static_cast<double>(count));
    EXPECT_GT(static_cast<double>(along_v), 0.99 * static_cast<double>(count));
    EXPECT_GT(static_cast<double>(outwards), 0.99 * static_cast<double>(count));
  }
}

TEST(Heart, SurfaceIsClosedAndSeamsShareNormals) {
  const Mesh& mesh = mesh_of(contracted());
  EXPECT_GE(mesh.indices.size() / 3, 10000u);
  std::map<std::pair<Place, Place>, int> walked;  // directed edges, by position
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto t = triangle(mesh, i);
    for (size_t k = 0; k < 3; ++k) {
      ASSERT_NE(place_of(t[k]), place_of(t[(k + 1) % 3])) << "triangle " << i / 3 << " has an edge of no length";
      ++walked[{place_of(t[k]), place_of(t[(k + 1) % 3])}];
    }
  }
  // Closed and consistently turned: every edge is walked once each way.
  for (const auto& [edge, times] : walked) {
    ASSERT_EQ(times, 1);
    ASSERT_TRUE(walked.contains({edge.second, edge.first}));
  }
  // A closed surface without handles: V - E + F = 2 (Euler).
  std::set<Place> places;
  for (const Vertex& v : mesh.vertices) places.insert(place_of(v));
  EXPECT_EQ(
      static_cast<long>(places.size()) - static_cast<long>(walked.size() / 2) + static_cast<long>(mesh.indices.size() / 3), 2);

  const auto seams = seam_vertices(mesh);
  EXPECT_GT(seams.size(), 100u);
  for (const auto& vertices : seams)
    for (const Vertex& v : vertices) ASSERT_EQ(v.normal, vertices[0].normal);
}

TEST(Heart, TexturesAgreeAcrossSeams) {
  for (const std::string name : {"outer_albedo", "inner_albedo"}) {
    const TextureImage& texture = *texture_of(expanded(), name);
    double across = 0, apart = 0;
    size_t pairs = 0;
    const auto seams = seam_vertices(mesh_of(expanded()));
    for (size_t i = 0; i < seams.size(); ++i) {
      const glm::vec4 here = sample(texture, seams[i][0].uv), there = sample(texture, seams[i][1].uv);
      // For comparison: some other place of the seam.
      const glm::vec4 elsewhere = sample(texture, seams[(i + seams.size() / 2) % seams.size()][1].uv);
      across += glm::length(here - there);
      apart += glm::length(here - elsewhere);
      ++pairs;
    }
    EXPECT_LT(across / static_cast<double>(pairs), 0.01) << name;
    EXPECT_GT(apart, 10 * across) << name;
  }
}

TEST(Heart, NormalMapAgreesAcrossSeamsInWorldSpace) {
  double across = 0, tilt = 0;
  const auto seams = seam_vertices(mesh_of(expanded()));
  for (const auto& vertices : seams) {
    std::array<glm::vec3, 2> world;
    for (size_t k = 0; k < 2; ++k) {
      const Vertex& v = vertices[k];
      const glm::vec3 n = 2.0f * glm::vec3(sample(*texture_of(expanded(), "outer_normal"), v.uv)) - 1.0f, tangent(v.tangent);
      world[k] = glm::normalize(tangent * n.x + v.tangent.w * glm::cross(v.normal, tangent) * n.y + v.normal * n.z);
    }
    across += glm::length(world[0] - world[1]);
    tilt += glm::length(world[0] - vertices[0].normal);
  }
  // The two sides differ by far less than the map tilts the normal: had one side the wrong frame, it would be twice the tilt.
  EXPECT_LT(across, 0.35 * tilt);
}

// Muscle and arteries are brighter on their ridges than between them, so where brightness rises to the right, the normal leans
// to the left, and where it rises downwards, the normal leans up: n = (-dh/du, -dh/dv, 1), with v down.
TEST(Heart, NormalMapLeansAwayFromRidges) {
  const TextureImage &albedo = *texture_of(expanded(), "outer_albedo"), &normal = *texture_of(expanded(), "outer_normal");
  double agree_u = 0, agree_v = 0, size_u = 0, size_v = 0;
  for (size_t y = 1; y + 1 < albedo.height; ++y)
    for (size_t x = 1; x + 1 < albedo.width; ++x) {
      const auto value = [&](const TextureImage& t, size_t i, size_t j, size_t channel) {
        return std::to_integer<int>(t.levels[0][4 * (j * t.width + i) + channel]);
      };
      // Muscle and arteries only: opaque and red.
      if (value(albedo, x, y, 3) > 25 || 2 * value(albedo, x, y, 2) > value(albedo, x, y, 0)) continue;
      const double u = (value(albedo, x + 1, y, 0) - value(albedo, x - 1, y, 0)) * (value(normal, x, y, 0) - 127.5);
      const double v = (value(albedo, x, y + 1, 0) - value(albedo, x, y - 1, 0)) * (value(normal, x, y, 1) - 127.5);
      agree_u += u;
      agree_v += v;
      size_u += std::abs(u);
      size_v += std::abs(v);
    }
  EXPECT_LT(agree_u, -0.1 * size_u);
  EXPECT_LT(agree_v, -0.1 * size_v);
}

TEST(Heart, TransparencyReachesBothEnds) {
  const Scene& scene = expanded();
  const TextureImage& outer = *texture_of(scene, "outer_albedo");
  size_t opaque = 0, clear = 0, between = 0;
  const size_t count = size_t{outer.width} * outer.height;
  for (size_t i = 0; i < count; ++i) {
    const float alpha = static_cast<float>(std::to_integer<int>(outer.levels[0][4 * i + 3])) / 255;
    opaque += alpha < 0.1f;
    clear += alpha > 0.8f;
    between += alpha >= 0.1f && alpha <= 0.8f;
  }
  EXPECT_GT(opaque, count / 10);
  EXPECT_GT(clear, count / 10);
  EXPECT_GT(between, count / 10);
  EXPECT_GT(transparency_of(scene.objects[0]), 0.8);
}

TEST(Heart, InnerLayerHasRedAndBlueVesselsOverDarkFlesh) {
  const TextureImage& inner = *texture_of(expanded(), "inner_albedo");
  size_t red = 0, blue = 0, flesh = 0;
  const size_t count = size_t{inner.width} * inner.height;
  for (size_t i = 0; i < count; ++i) {
    const auto channel = [&](size_t c) { return std::to_integer<int>(inner.levels[0][4 * i + c]); };
    red += channel(0) > 200 && channel(2) < 80;
    blue += channel(2) > 140 && channel(2) > channel(0) + 40;
    flesh += channel(0) < 160 && channel(0) > channel(2) + 30;
  }
  EXPECT_GT(red, count / 50);
  EXPECT_GT(blue, count / 50);
  EXPECT_GT(flesh, count / 3);
}

TEST(Heart, SystoleShrinksTheHeartAndThinsTheLayer) {
  const double diastole = signed_volume(mesh_of(expanded())), systole = signed_volume(mesh_of(contracted()));
  EXPECT_GT(systole, 0) << "triangles face outwards";
  EXPECT_LT(systole, 0.9 * diastole);
  EXPECT_GT(systole, 0.5 * diastole);
  // Figure 11: about 16 and 5 texels at 1024, so a quarter of that at 256.
  EXPECT_NEAR(thickness_of(expanded().objects[0]), 4, 0.5);
  EXPECT_NEAR(thickness_of(contracted().objects[0]), 1.25, 0.25);
}

TEST(Heart, BeatsWithItsPeriodAtAnyTime) {
  for (const float time : {0.13f, 0.45f, 0.62f}) {
    const Scene now = heart(time, 64);
    for (const float later : {time + period_s, time - 3 * period_s}) {
      const Scene then = heart(later, 64);
      EXPECT_NEAR(thickness_of(now.objects[0]), thickness_of(then.objects[0]), 1e-4);
      float farthest = 0;
      for (size_t i = 0; i < mesh_of(now).vertices.size(); ++i)
        farthest = std::max(farthest, glm::distance(mesh_of(now).vertices[i].position, mesh_of(then).vertices[i].position));
      EXPECT_LT(farthest, 1e-4f);
    }
  }
  EXPECT_NO_THROW(make_heart({.time_s = -1e30f, .texture_size = 64}));
}

TEST(Heart, SameBytesTwiceAndTexturesStayPut) {
  const Scene again = heart(period_s / 3, 256);
  const Mesh &a = mesh_of(contracted()), &b = mesh_of(again);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (size_t i = 0; i < a.vertices.size(); ++i) ASSERT_EQ(a.vertices[i].position, b.vertices[i].position);
  EXPECT_EQ(a.indices, b.indices);
  for (size_t i = 0; i < a.vertices.size(); ++i) ASSERT_EQ(a.vertices[i].uv, mesh_of(expanded()).vertices[i].uv);
  EXPECT_EQ(texture_of(again, "outer_albedo"), texture_of(expanded(), "outer_albedo")) << "made once a size, whatever the time";
}

TEST(Heart, RefusesTimesAndSizesThatAreNone) {
  for (const float time : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) try {
      make_heart({.time_s = time});
      ADD_FAILURE() << "no error for time " << time;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
  for (const uint32_t size : {0u, 32u, 1000u, 8192u}) try {
      make_heart({.time_s = 0, .texture_size = size});
      ADD_FAILURE() << "no error for size " << size;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
}

TEST(Heart, SceneHasLightsAndViewsAndMoves) {
  const Scene& scene = expanded();
  EXPECT_TRUE(scene.mesh_moves);
  EXPECT_EQ(scene.lights.size(), 3u);
  std::vector<std::string> views;
  for (const View& view : scene.views) views.push_back(view.name);
  EXPECT_EQ(views, (std::vector<std::string>{"front", "three_quarter", "grazing"}));
  for (const Light& light : scene.lights) EXPECT_NEAR(glm::length(light.direction), 1, 1e-5);
  for (const View& view : scene.views)
    for (const Vertex& v : mesh_of(scene).vertices)
      ASSERT_GT(glm::distance(v.position, view.eye), 2 * view.near_m) << view.name;
}

}  // namespace
}  // namespace lamina
