// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/gltf/gltf_values.h"

namespace lamina {
namespace {

using Path = GltfChannel::Path;
using Interpolation = GltfChannel::Interpolation;

constexpr std::array path_names = {"translation", "rotation", "scale", "weights"};
constexpr std::array interpolation_names = {"LINEAR", "STEP", "CUBICSPLINE"};

std::string text_in(const nlohmann::json& object, const char* name, const char* otherwise) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  return found->is_string() ? found->get<std::string>() : std::string();
}

void read_sampler_of(GltfChannel& channel, const nlohmann::json& from, nlohmann::json& animation, const std::string& about) {
  nlohmann::json* samplers = list_of(animation, "samplers", about);
  const int index = index_in(from, "sampler", about);
  if (!samplers || index < 0 || size_t(index) >= samplers->size())
    refuse_gltf(about, fmt::format("refers to sampler {}; the animation has {}", index, samplers ? samplers->size() : 0));
  const nlohmann::json& sampler = (*samplers)[size_t(index)];
  channel.input = index_in(sampler, "input", about);
  channel.output = index_in(sampler, "output", about);
  const auto named = std::ranges::find(interpolation_names, text_in(sampler, "interpolation", "LINEAR"));
  if (named == interpolation_names.end())
    refuse_gltf(about, fmt::format("its interpolation is none of {}", fmt::join(interpolation_names, ", ")));
  channel.interpolation = static_cast<Interpolation>(named - interpolation_names.begin());
}

// Numbers a key of a node's morph weights: as many as its mesh has targets.
size_t morph_targets(const tinygltf::Model& model, const tinygltf::Node& node) {
  if (node.mesh < 0 || size_t(node.mesh) >= model.meshes.size()) return 0;
  const tinygltf::Mesh& mesh = model.meshes[size_t(node.mesh)];
  return mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
}

std::vector<double> key_times(const tinygltf::Model& model, int accessor, const std::string& about) {
  std::vector<double> times = read_accessor(model, accessor, 1, about + ", input");
  if (times.empty()) refuse_gltf(about, "has no keys");
  for (size_t i = 0; i < times.size(); ++i)
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
      refuse_gltf(about, fmt::format("the time of key {} is not after the one before", i));
  return times;
}

// The channel's numbers at that time, for its node.
std::vector<double> played(const tinygltf::Model& model, const GltfChannel& channel, size_t width, double time_s,
                           const std::string& about) {
  const std::vector<double> times = key_times(model, channel.input, about);
  const bool weights = channel.path == Path::weights;
  const std::vector<double> values =
      read_accessor(model, channel.output, weights ? 1 : static_cast<int>(width), about + ", output");
  const size_t each = width * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
  if (values.size() != each * times.size())
    refuse_gltf(about, fmt::format("has {} keys, and {} numbers where each key needs {}", times.size(), values.size(), each));
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    refuse_gltf(about, "holds a number that is not finite");
  return keyed_values(times, values, width, channel.interpolation, channel.path == Path::rotation, time_s);
}

glm::dquat quaternion(const double* v) { return glm::dquat(v[3], v[0], v[1], v[2]); }

// The rotation of a quaternion of any length; none where it is zero.
glm::dquat unit(const glm::dquat& of) {
  const double length = glm::length(of);
  return length > 0 ? of * (1 / length) : glm::dquat(1, 0, 0, 0);
}
std::vector<double> numbers_of(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }

// Appendix C.4: an even turn along the shorter arc, by Shoemake, "Animating Rotation with Quaternion Curves", SIGGRAPH 1985.
std::vector<double> turned(const double* from, const double* to, double share) {
  const glm::dquat a = unit(quaternion(from));
  glm::dquat b = unit(quaternion(to));
  double cosine = glm::dot(a, b);
  if (cosine < 0) b = -b, cosine = -cosine;
  const double angle = std::acos(std::min(cosine, 1.0));
  if (angle < 1e-9) return numbers_of(a);  // the sine would vanish
  return numbers_of(unit(a * std::sin((1 - share) * angle) + b * std::sin(share * angle)));
}

}  // namespace

std::vector<double> keyed_values(const std::vector<double>& times, const std::vector<double>& values, size_t width,
                                 Interpolation interpolation, bool rotation, double time_s) {
  const bool spline = interpolation == Interpolation::cubic_spline;
  const size_t stride = spline ? 3 * width : width;
  const auto value = [&](size_t key) { return values.data() + key * stride + (spline ? width : 0); };
  const auto held = [&](size_t key) {
    return rotation ? numbers_of(unit(quaternion(value(key)))) : std::vector<double>(value(key), value(key) + width);
  };
  const size_t next = static_cast<size_t>(std::ranges::upper_bound(times, time_s) - times.begin());
  if (next == 0) return held(0);
  const size_t key = next - 1;
  if (next == times.size() || interpolation == Interpolation::step) return held(key);

  const double interval = times[next] - times[key], t = (time_s - times[key]) / interval;
  if (interpolation == Interpolation::linear && rotation) return turned(value(key), value(next), t);
  std::vector<double> result(width);
  for (size_t i = 0; i < width; ++i) {
    const double from = value(key)[i], to = value(next)[i];
    if (!spline) {
      result[i] = from + t * (to - from);
      continue;
    }
    // Appendix C.5, Hermite's cubic: tangents are by the second.
    const double leaving = interval * values[key * stride + 2 * width + i], arriving = interval * values[next * stride + i];
    const double t2 = t * t, t3 = t2 * t;
    result[i] = (2 * t3 - 3 * t2 + 1) * from + (t3 - 2 * t2 + t) * leaving + (3 * t2 - 2 * t3) * to + (t3 - t2) * arriving;
  }
  return rotation ? numbers_of(unit(quaternion(result.data()))) : result;
}

std::optional<GltfAnimation> take_first_animation(nlohmann::json& root, const std::string& subject) {
  nlohmann::json* list = list_of(root, "animations", subject);
  if (!list || list->empty()) return std::nullopt;
  nlohmann::json& first = list->front();
  GltfAnimation animation;
  animation.of = list->size();
  const std::string name = text_in(first, "name", "");
  animation.name = name.empty() ? "animation 0" : fmt::format("animation '{}'", name);
  if (nlohmann::json* channels = list_of(first, "channels", fmt::format("{}: {}", subject, animation.name)))
    for (size_t i = 0; i < channels->size(); ++i) {
      const nlohmann::json& from = (*channels)[i];
      const std::string about = fmt::format("{}: {}, channel {}", subject, animation.name, i);
      const auto target = from.find("target");
      if (target == from.end() || !target->is_object()) refuse_gltf(about, "has no 'target'");
      const auto path = std::ranges::find(path_names, text_in(*target, "path", ""));
      GltfChannel channel;
      channel.node = index_in(*target, "node", about);
      if (channel.node < 0 || path == path_names.end()) continue;
      channel.path = static_cast<Path>(path - path_names.begin());
      read_sampler_of(channel, from, first, about);
      animation.channels.push_back(channel);
    }
  root.erase("animations");
  return animation;
}

AnimatedNodes play(tinygltf::Model& model, const GltfAnimation& animation, double time_s) {
  AnimatedNodes animated;
  for (const GltfChannel& channel : animation.channels) {
    const std::string about =
        fmt::format("{}, the {} of node {}", animation.name, path_names[size_t(channel.path)], channel.node);
    if (size_t(channel.node) >= model.nodes.size())
      refuse_gltf(about, fmt::format("the file has {} nodes", model.nodes.size()));
    tinygltf::Node& node = model.nodes[size_t(channel.node)];
    const bool weights = channel.path == Path::weights;
    if (!weights && !node.matrix.empty())
      refuse_gltf(about, "the node is placed by a matrix; what moves needs translation, rotation and scale");
    const size_t width = weights ? morph_targets(model, node) : channel.path == Path::rotation ? 4 : 3;
    if (width == 0) continue;  // the weights of a node without targets
    std::vector<double> values = played(model, channel, width, time_s, about);
    (weights ? animated.weighted : animated.placed).insert(channel.node);
    switch (channel.path) {
      case Path::translation:
        node.translation = std::move(values);
        break;
      case Path::rotation:
        node.rotation = std::move(values);
        break;
      case Path::scale:
        node.scale = std::move(values);
        break;
      case Path::weights:
        node.weights = std::move(values);
        break;
    }
  }
  return animated;
}

}  // namespace lamina
