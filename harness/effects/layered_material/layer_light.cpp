// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/layered_material/layer_light.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace lamina {
namespace {

int repeated(int at, int count) { return ((at % count) + count) % count; }

}  // namespace

LayerLight::LayerLight(const Scene& scene, const Object& object, const TextureImage& normals)
    : scene_(scene),
      normals_(normals),
      width_(static_cast<int>(normals.width)),
      height_(static_cast<int>(normals.height)),
      chart_of_(size_t(width_) * size_t(height_), -1) {
  // A normal map of one texel is a grid too coarse for charts.
  if (width_ < 256 || height_ < 256) {
    width_ = std::max(width_, 256), height_ = std::max(height_, 256);
    chart_of_.assign(size_t(width_) * size_t(height_), -1);
  }
  const Mesh& mesh = object.mesh;
  const glm::dmat4 world_from_object(object.world_from_object);
  const glm::dmat3 turned(world_from_object), normal_matrix = glm::transpose(glm::inverse(turned));
  const double side = glm::determinant(turned) < 0 ? -1 : 1;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<glm::dvec2, 3> uv;
    Chart chart;
    for (size_t c = 0; c < 3; ++c) {
      const Vertex& vertex = mesh.vertices[mesh.indices[i + c]];
      uv[c] = glm::dvec2(vertex.uv);
      chart.position[c] = glm::dvec3(world_from_object * glm::dvec4(vertex.position, 1));
      chart.normal[c] = normal_matrix * glm::dvec3(vertex.normal);
      chart.tangent[c] = turned * glm::dvec3(vertex.tangent);
    }
    chart.handedness = double(mesh.vertices[mesh.indices[i]].tangent.w) * side < 0 ? -1 : 1;
    chart.first_uv = uv[0];
    const glm::dmat2 uv_from_weights(uv[1] - uv[0], uv[2] - uv[0]);
    if (std::abs(glm::determinant(uv_from_weights)) < 1e-14) continue;
    chart.weights_from_uv = glm::inverse(uv_from_weights);
    charts_.push_back(chart);
    cover(static_cast<uint32_t>(charts_.size() - 1), glm::min(uv[0], glm::min(uv[1], uv[2])),
          glm::max(uv[0], glm::max(uv[1], uv[2])));
  }
  spread();
}

// Texels whose middle lies in the triangle, which reaches from `low` to `high`.
void LayerLight::cover(uint32_t triangle, glm::dvec2 low, glm::dvec2 high) {
  const Chart& chart = charts_[triangle];
  const int left = std::max(static_cast<int>(std::floor(low.x * width_)), 0),
            right = std::min(static_cast<int>(std::ceil(high.x * width_)), width_);
  const int top = std::max(static_cast<int>(std::floor(low.y * height_)), 0),
            bottom = std::min(static_cast<int>(std::ceil(high.y * height_)), height_);
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const glm::dvec2 w = chart.weights_from_uv * (glm::dvec2((x + 0.5) / width_, (y + 0.5) / height_) - chart.first_uv);
      if (w.x >= -1e-9 && w.y >= -1e-9 && w.x + w.y <= 1 + 1e-9)
        chart_of_[size_t(y) * size_t(width_) + size_t(x)] = static_cast<int32_t>(triangle);
    }
}

// From texel to texel, the nearest of what the neighbours know first: near enough to the nearest of all, over a texture that
// repeats.
void LayerLight::spread() {
  nearest_of_.assign(chart_of_.size(), -1);
  std::deque<int32_t> front;
  for (size_t i = 0; i < chart_of_.size(); ++i)
    if (chart_of_[i] >= 0) nearest_of_[i] = static_cast<int32_t>(i), front.push_back(static_cast<int32_t>(i));
  const auto apart = [&](int32_t a, int32_t b) {
    const auto wrapped = [](int d, int n) { return std::min(std::abs(d), n - std::abs(d)); };
    const int dx = wrapped(a % width_ - b % width_, width_), dy = wrapped(a / width_ - b / width_, height_);
    return int64_t{dx} * dx + int64_t{dy} * dy;
  };
  while (!front.empty()) {
    const int32_t at = front.front();
    front.pop_front();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int32_t there = repeated(at / width_ + dy, height_) * width_ + repeated(at % width_ + dx, width_);
        const int32_t known = nearest_of_[size_t(there)], offered = nearest_of_[size_t(at)];
        if (known >= 0 && apart(known, there) <= apart(offered, there)) continue;
        nearest_of_[size_t(there)] = offered;
        front.push_back(there);
      }
  }
}

glm::dvec3 LayerLight::mapped_normal(glm::dvec2 uv) const {
  const glm::dvec3 n = glm::dvec3(normals_.base(uv)) * 2.0 - 1.0;
  const double squared = glm::dot(n, n);
  return squared > 1e-6 ? n / std::sqrt(squared) : glm::dvec3(0, 0, 1);
}

LightsAt LayerLight::at(glm::dvec2 uv) const {
  const std::optional<LayerPlace> there = place(uv);
  return there ? lights(*there, mapped_normal(there->uv)) : LightsAt{};
}

glm::dvec3 LayerLight::at(glm::dvec2 uv, size_t i) const {
  const std::optional<LayerPlace> there = place(uv);
  return there ? light(*there, mapped_normal(there->uv), i) : glm::dvec3(0);
}

std::optional<LayerPlace> LayerLight::place(glm::dvec2 uv) const {
  uv -= glm::floor(uv);
  const size_t texel = size_t(std::min(static_cast<int>(uv.y * height_), height_ - 1)) * size_t(width_) +
                       size_t(std::min(static_cast<int>(uv.x * width_), width_ - 1));
  const int32_t nearest = nearest_of_[texel];
  if (nearest < 0) return std::nullopt;
  if (size_t(nearest) != texel) uv = {(nearest % width_ + 0.5) / width_, (nearest / width_ + 0.5) / height_};
  const Chart& chart = charts_[size_t(chart_of_[size_t(nearest)])];
  const glm::dvec2 w = chart.weights_from_uv * (uv - chart.first_uv);
  const auto mixed = [&](const std::array<glm::dvec3, 3>& of) { return (1 - w.x - w.y) * of[0] + w.x * of[1] + w.y * of[2]; };
  LayerPlace there{uv, mixed(chart.position), {}, {}, glm::normalize(mixed(chart.normal))};
  const glm::dvec3& normal = there.normal;
  glm::dvec3 along = mixed(chart.tangent);
  along -= normal * glm::dot(normal, along);
  there.along = glm::dot(along, along) > 1e-12
                    ? glm::normalize(along)
                    : glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  there.across = glm::cross(normal, there.along) * chart.handedness;
  return there;
}

LightFrom LayerLight::from(const LayerPlace& place, size_t i) const {
  const Light& light = scene_.lights[i];
  const bool point = light.kind == Light::Kind::point;
  const glm::dvec3 to_light = point ? glm::dvec3(light.position) - place.position : -glm::dvec3(light.direction);
  const double squared = std::max(glm::dot(to_light, to_light), 1e-8);
  return {to_light / std::sqrt(squared), glm::dvec3(light.radiance) / (point ? squared : 1.0)};
}

glm::dvec3 LayerLight::light(const LayerPlace& place, glm::dvec3 tangent_normal, size_t i) const {
  const glm::dvec3 lit = place.along * tangent_normal.x + place.across * tangent_normal.y + place.normal * tangent_normal.z;
  const LightFrom light = from(place, i);
  return light.irradiance * std::max(glm::dot(lit, light.direction), 0.0);
}

LightsAt LayerLight::lights(const LayerPlace& place, glm::dvec3 tangent_normal) const {
  LightsAt lights{};
  for (size_t i = 0; i < std::min(scene_.lights.size(), max_lights); ++i) lights[i] = light(place, tangent_normal, i);
  return lights;
}

}  // namespace lamina
