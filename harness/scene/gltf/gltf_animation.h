// SPDX-License-Identifier: Apache-2.0
// glTF 2.0's animations (Khronos Group, "glTF 2.0 Specification", 2021, section 3.11 and appendix C): nodes' places and morph
// weights by keyframes, played at one moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace lamina {

struct GltfChannel {
  enum class Path : uint8_t { translation, rotation, scale, weights } path = Path::translation;
  enum class Interpolation : uint8_t { linear, step, cubic_spline } interpolation = Interpolation::linear;
  int node = 0;
  int input = 0, output = 0;  // accessors: seconds, and values
};

struct GltfAnimation {
  std::string name;  // "animation 'walk'"
  size_t of = 1;     // so many that the file has
  std::vector<GltfChannel> channels;
};

// The file's first animation, taken out of its JSON with all others, which are not read; nothing where it has none. Channels
// without a node, or of a path that glTF 2.0 has not, are left out (section 3.11). Throws Error(bad_input) about `subject`.
std::optional<GltfAnimation> take_first_animation(nlohmann::json& root, const std::string& subject);

// What an animation changes, by node.
struct AnimatedNodes {
  std::set<int> placed;    // translation, rotation or scale
  std::set<int> weighted;  // morph weights
};

// Puts the model's nodes where the animation has them at `time_s`. Before the first key and after the last one their values
// hold (appendix C.1). Throws Error(bad_input) naming the animation and channel.
AnimatedNodes play(tinygltf::Model& model, const GltfAnimation& animation, double time_s);

// The values of one channel's keys at a time, by themselves: `times` in seconds, ascending; for each key `width` numbers in
// `values`, or three times as many where it is a spline (in-tangent, value, out-tangent). A rotation is four numbers, x y z w;
// LINEAR turns it at an even speed along the shorter arc, and the answer is of length one.
std::vector<double> keyed_values(const std::vector<double>& times, const std::vector<double>& values, size_t width,
                                 GltfChannel::Interpolation interpolation, bool rotation, double time_s);

}  // namespace lamina
