// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/skin_baker.h"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <span>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/effects/skin/profile.h"

namespace lamina {
namespace {

// Numbers of places, from 0; vertices of one place share one.
std::vector<size_t> places_of(const Mesh& mesh, size_t& count) {
  std::map<std::array<float, 3>, size_t> known;
  std::vector<size_t> place_of;
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 p = vertex.position;
    place_of.push_back(known.try_emplace({p.x, p.y, p.z}, known.size()).first->second);
  }
  count = known.size();
  return place_of;
}

class SkinBaker : public Baker {
 public:
  explicit SkinBaker(const Scene& scene) : scene_(scene) {}

  Baked bake(size_t object, const EffectValues& values, const BakeOptions&) override {
    const Object& skin = scene_.objects[object];
    if (const std::string problem = profile_problem(profile_of(values)); !problem.empty())
      throw Error(ErrorKind::bad_input, "bake", fmt::format("object '{}'", skin.name), problem);
    const double scale = std::cbrt(std::abs(double(glm::determinant(glm::mat3(skin.world_from_object)))));
    std::vector<float> curvatures = mean_curvatures(skin.mesh);
    for (float& curvature : curvatures) curvature = static_cast<float>(double(curvature) / (1000 * scale));
    Baked baked;
    const std::span<const std::byte> bytes = std::as_bytes(std::span(curvatures));
    baked.buffers["Curvatures"] = {bytes.begin(), bytes.end()};
    return baked;
  }

 private:
  const Scene& scene_;
};

std::string skin_problem(const BakeOptions& options) {
  return options.empty() ? "" : fmt::format("skin takes no [bake], and so no '{}'", options.begin()->first);
}
std::vector<BakedName> skin_names(const BakeOptions&) { return {{"Curvatures", true, {}}}; }
std::map<std::string, std::string> skin_defines(const BakeOptions&) { return {}; }
std::unique_ptr<Baker> start_skin(const Scene& scene, BakeTools&) { return std::make_unique<SkinBaker>(scene); }

}  // namespace

std::vector<float> mean_curvatures(const Mesh& mesh) {
  size_t count = 0;
  const std::vector<size_t> place_of = places_of(mesh, count);
  std::vector<double> turned(count), edges(count);
  const auto each_edge = [&](const auto& visit) {
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
      for (size_t k = 0; k < 3; ++k) visit(mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]);
  };
  each_edge([&](uint32_t a, uint32_t b) {
    const glm::dvec3 along = glm::dvec3(mesh.vertices[b].position) - glm::dvec3(mesh.vertices[a].position);
    const glm::dvec3 turn = glm::dvec3(mesh.vertices[b].normal) - glm::dvec3(mesh.vertices[a].normal);
    const double squared = glm::dot(along, along);
    if (squared <= 0) return;
    for (const uint32_t end : {a, b}) turned[place_of[end]] += glm::dot(along, turn) / squared, ++edges[place_of[end]];
  });
  std::vector<double> mean(count);
  for (size_t i = 0; i < count; ++i) mean[i] = edges[i] > 0 ? turned[i] / edges[i] : 0;
  // Over neighbours, so that no single edge shows.
  std::vector<double> sum = mean, weight(count, 1);
  each_edge([&](uint32_t a, uint32_t b) {
    const size_t x = place_of[a], y = place_of[b];
    sum[x] += mean[y], ++weight[x], sum[y] += mean[x], ++weight[y];
  });
  std::vector<float> curvatures;
  for (const size_t place : place_of) curvatures.push_back(static_cast<float>(sum[place] / weight[place]));
  return curvatures;
}

const BakerCode skin_baker = {skin_problem, skin_names, skin_defines, start_skin};

}  // namespace lamina
