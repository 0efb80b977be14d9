// SPDX-License-Identifier: Apache-2.0
// Animations at one moment, from the closed forms of the specification's appendix C, and models that are played.
#include "harness/scene/gltf/gltf_animation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/scene/gltf/gltf.h"
#include "tests/scene/declared.h"
#include "tests/scene/made_files.h"

namespace lamina {
namespace {

using Interpolation = GltfChannel::Interpolation;
using KeyNumbers = std::vector<double>;

void expect_numbers(const KeyNumbers& is, const KeyNumbers& should, double tolerance, const std::string& where) {
  ASSERT_EQ(is.size(), should.size()) << where;
  for (size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i], should[i], tolerance) << where << ", number " << i;
}

TEST(GltfAnimation, LinearAndStepBetweenTheirKeysAndHeldBeyondThem) {
  const KeyNumbers times = {1, 2, 4}, values = {0, 10, 4, 20, -4, 40};
  const auto linear = [&](double t) { return keyed_values(times, values, 2, Interpolation::linear, false, t); };
  const auto step = [&](double t) { return keyed_values(times, values, 2, Interpolation::step, false, t); };
  for (const double before : {-1e9, 0.0, 1.0}) expect_numbers(linear(before), {0, 10}, 0, "before the first key");
  for (const double after : {4.0, 4.1, 1e9}) expect_numbers(linear(after), {-4, 40}, 0, "after the last key");
  expect_numbers(linear(1.25), {1, 12.5}, 1e-12, "a quarter");
  expect_numbers(linear(2), {4, 20}, 1e-12, "at a key");
  expect_numbers(linear(3), {0, 30}, 1e-12, "half way of the second interval");
  expect_numbers(step(1.999), {0, 10}, 0, "the key before");
  expect_numbers(step(2), {4, 20}, 0, "from its key on");
  expect_numbers(step(5), {-4, 40}, 0, "after the last key");
  for (const Interpolation any : {Interpolation::linear, Interpolation::step})
    expect_numbers(keyed_values({3}, {7}, 1, any, false, 100), {7}, 0, "one key holds always");
}

// A turn of `degrees` about z.
KeyNumbers about_z(double degrees) {
  const double half = degrees * M_PI / 360;
  return {0, 0, std::sin(half), std::cos(half)};
}
KeyNumbers joined(const std::vector<KeyNumbers>& parts) {
  KeyNumbers all;
  for (const KeyNumbers& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(GltfAnimation, ALinearRotationTurnsEvenlyAlongTheShorterArc) {
  const auto between = [](const KeyNumbers& a, const KeyNumbers& b, double t) {
    return keyed_values({0, 1}, joined({a, b}), 4, Interpolation::linear, true, t);
  };
  for (const double to : {10.0, 90.0, 170.0, -120.0})
    for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0})
      expect_numbers(between(about_z(0), about_z(to), t), about_z(t * to), 1e-12, fmt::format("{} of {} degrees", t, to));
  // The same place by the other sign of the quaternion: the shorter way is still taken.
  KeyNumbers other_sign = about_z(90);
  for (double& v : other_sign) v = -v;
  expect_numbers(between(about_z(0), other_sign, 0.5), about_z(45), 1e-12, "half way to the other sign");
  expect_numbers(between(about_z(30), about_z(30), 0.5), about_z(30), 1e-12, "no turn at all");
  // Of any length in the file, of length one when it is played.
  KeyNumbers twice = about_z(60);
  for (double& v : twice) v *= 2;
  expect_numbers(between(twice, twice, 2), about_z(60), 1e-12, "after the last key");
}

TEST(GltfAnimation, ACubicSplineIsHermites) {
  // p(t) = t^3 - 2 t^2 + 3 t + 1 for t in 0 to 2 s: a cubic, which the spline must give back from its ends and slopes.
  const auto p = [](double t) { return t * t * t - 2 * t * t + 3 * t + 1; };
  const auto slope = [](double t) { return 3 * t * t - 4 * t + 3; };
  const KeyNumbers times = {0, 0.5, 2};
  KeyNumbers values;
  for (const double t : times) values.insert(values.end(), {slope(t), p(t), slope(t)});
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.3, 1.999, 2.0})
    expect_numbers(keyed_values(times, values, 1, Interpolation::cubic_spline, false, t), {p(t)}, 1e-12,
                   fmt::format("at {}", t));
  expect_numbers(keyed_values(times, values, 1, Interpolation::cubic_spline, false, -1), {p(0)}, 0, "before the first key");
  expect_numbers(keyed_values(times, values, 1, Interpolation::cubic_spline, false, 3), {p(2)}, 0, "after the last key");
  // In- and out-tangents are told apart: with both slopes 0 half way is the mean, and the first key's in-tangent is not used.
  const KeyNumbers flat = {99, 0, 0, 0, 8, 99};
  expect_numbers(keyed_values({0, 1}, flat, 1, Interpolation::cubic_spline, false, 0.5), {4}, 1e-12, "half way");
  // A rotation's four numbers are of length one again.
  const KeyNumbers still(4, 0);
  const KeyNumbers turn = joined({still, about_z(0), still, still, about_z(90), still});
  expect_numbers(keyed_values({0, 1}, turn, 4, Interpolation::cubic_spline, true, 0.5), about_z(45), 1e-12, "half a turn");
}

// A quad with one morph target (z up by 1), a skin of one joint, and the channels that a test gives.
struct Played {
  GltfMaker maker;
  std::vector<std::string> channels, samplers;
  std::string mesh;

  Played() {
    mesh = maker.quad(fmt::format(R"(,"targets":[{{"POSITION":{}}}])", maker.add_floats(Repeated(4).of({0, 0, 1}), 3)));
  }
  struct Repeated {
    explicit Repeated(int n) : times(n) {}
    std::vector<float> of(const std::vector<float>& one) const {
      std::vector<float> all;
      for (int i = 0; i < times; ++i) all.insert(all.end(), one.begin(), one.end());
      return all;
    }
    int times;
  };

  Played& channel(const std::string& target, const std::vector<float>& times, const std::vector<float>& values, int width,
                  const std::string& interpolation = "") {
    const int input = maker.add_floats(times, 1), output = maker.add_floats(values, width);
    channels.push_back(fmt::format(R"({{"sampler":{},"target":{{{}}}}})", samplers.size(), target));
    samplers.push_back(fmt::format(R"({{"input":{},"output":{}{}}})", input, output,
                                   interpolation.empty() ? "" : fmt::format(R"(,"interpolation":"{}")", interpolation)));
    return *this;
  }
  std::string glb(const std::vector<std::string>& nodes, const std::string& members = "") const {
    GltfMaker whole = maker;
    whole.add_mesh("quad", {mesh});
    for (const std::string& node : nodes) whole.add_node(node);
    whole.more = fmt::format(R"(,"animations":[{{"name":"walk","channels":[{}],"samplers":[{}]}},{{"name":"run"}}]{})",
                             fmt::join(channels, ","), fmt::join(samplers, ","), members);
    return whole.glb();
  }
};

LoadedModel load_at(const Folder& folder, const Played& played, const std::vector<std::string>& nodes,
                    std::optional<double> time_s, const std::string& members = "") {
  return load_gltf(folder.write("model.glb", played.glb(nodes, members)), time_s);
}
const std::string of_node_0 = R"("node":0,"path":)";
const std::string drawn_node = R"({"mesh":0,"name":"thing","translation":[0,0,5]})";

TEST(GltfAnimation, NodesArePlacedAsTheTimeSays) {
  const Folder folder;
  Played played;
  played.channel(of_node_0 + R"("translation")", {0, 2}, {0, 0, 0, 4, 0, 0}, 3)
      .channel(of_node_0 + R"("scale")", {0, 2}, {1, 1, 1, 3, 3, 3}, 3, "STEP")
      .channel(of_node_0 + R"("rotation")", {0, 2}, {0, 0, 0, 1, 0, 0, 1, 0}, 4)
      .channel(R"("path":"translation")", {0}, {9, 9, 9}, 3)    // no node: ignored
      .channel(of_node_0 + R"("pointer")", {0}, {9, 9, 9}, 3);  // no path of glTF 2.0
  const LoadedModel model = load_at(folder, played, {drawn_node}, 1);
  const glm::mat4 place = model.objects.at(0).world_from_object;
  // Half way: moved by 2, turned by 90 degrees about z, of its first size.
  EXPECT_LT(glm::distance(glm::vec3(place[3]), glm::vec3(2, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(glm::vec3(place[0]), glm::vec3(0, 1, 0)), 1e-6f);
  EXPECT_TRUE(model.objects_move);
  EXPECT_FALSE(model.mesh_moves) << "the mesh itself stays as it is";
  EXPECT_NE(fmt::format("{}", fmt::join(model.warnings, "|")).find("animation 'walk', the first of 2, is played to 1 s"),
            std::string::npos)
      << model.warnings.at(0);
  const LoadedModel rest = load_at(folder, played, {drawn_node}, std::nullopt);
  EXPECT_EQ(glm::vec3(rest.objects.at(0).world_from_object[3]), glm::vec3(0, 0, 5)) << "without a time as the file places it";
  EXPECT_FALSE(rest.objects_move);
  EXPECT_NE(rest.warnings.at(0).find("animations are not played"), std::string::npos);
  // A node that draws nothing.
  const LoadedModel empty = load_at(folder, played, {R"({"name":"empty"})", drawn_node}, 1);
  EXPECT_FALSE(empty.objects_move || empty.mesh_moves);
  // And one above the drawn one.
  const LoadedModel above = load_at(folder, played, {R"({"children":[1]})", drawn_node}, 1);
  EXPECT_TRUE(above.objects_move);
  EXPECT_LT(glm::distance(glm::vec3(above.objects.at(0).world_from_object[3]), glm::vec3(2, 0, 5)), 1e-6f);
}

TEST(GltfAnimation, MorphWeightsChangeTheMesh) {
  const Folder folder;
  Played played;
  played.channel(of_node_0 + R"("weights")", {0, 1}, {0, 1}, 1);
  const LoadedModel model = load_at(folder, played, {drawn_node}, 0.25);
  for (const Vertex& vertex : model.objects.at(0).mesh.vertices) EXPECT_FLOAT_EQ(vertex.position.z, 0.25f);
  EXPECT_TRUE(model.mesh_moves);
  EXPECT_FALSE(model.objects_move);
}

TEST(GltfAnimation, JointsMoveTheirSkin) {
  const Folder folder;
  Played played;
  played.channel(R"("node":1,"path":"translation")", {0, 1}, {0, 0, 0, 0, 8, 0}, 3);
  const int joints = played.maker.add_accessor(std::vector<uint8_t>(16, 0), 4, 5121);
  const int weights = played.maker.add_floats(Played::Repeated(4).of({1, 0, 0, 0}), 4);
  const std::string before = R"("attributes":{)";
  played.mesh.insert(played.mesh.find(before) + before.size(),
                     fmt::format(R"("JOINTS_0":{},"WEIGHTS_0":{},)", joints, weights));
  const std::vector<std::string> nodes = {R"({"mesh":0,"skin":0})", R"({"children":[2]})", R"({"translation":[1,0,0]})"};
  const LoadedModel model = load_at(folder, played, nodes, 0.5, R"(,"skins":[{"joints":[2]}])");
  EXPECT_EQ(model.objects.at(0).mesh.vertices.at(0).position, glm::vec3(1, 4, 0)) << "the joint's parent has moved";
  EXPECT_TRUE(model.mesh_moves);
  EXPECT_EQ(fmt::format("{}", fmt::join(model.warnings, "|")).find("at rest"), std::string::npos);
}

TEST(GltfAnimation, TheSceneSaysTheTime) {
  const Folder folder;
  Played played;
  played.channel(of_node_0 + R"("translation")", {0, 2}, {0, 0, 0, 4, 0, 0}, 3);
  const std::string model = folder.write("model.glb", played.glb({drawn_node})).string();
  const auto x_of = [](const Scene& scene) { return scene.objects.at(0).world_from_object[3].x; };
  EXPECT_EQ(x_of(load_scene(model, builtin_library())), 0) << "at rest";
  EXPECT_FALSE(load_scene(model, builtin_library()).moves());
  const Scene half = load_scene(model, builtin_library(), 1.0f);
  EXPECT_EQ(x_of(half), 2);
  EXPECT_TRUE(half.objects_move && !half.mesh_moves && half.moves());
  const std::string file = folder.write("scene.toml", "[scene]\nmodel = \"model.glb\"\ntime = 1.5\n").string();
  EXPECT_EQ(x_of(load_scene(file, builtin_library())), 3);
  EXPECT_EQ(x_of(load_scene(file, builtin_library(), 0.5f)), 1) << "the command line goes first";
}

TEST(GltfAnimation, WhatCannotBePlayedIsRefusedOnlyWhereItIsPlayed) {
  const Folder folder;
  const auto refused = [&](const std::string& target, const std::vector<float>& times, const std::vector<float>& values,
                           int width, const std::string& interpolation, const std::vector<std::string>& parts,
                           const std::string& node = drawn_node) {
    Played played;
    played.channel(target, times, values, width, interpolation);
    EXPECT_NO_THROW(load_at(folder, played, {node}, std::nullopt));
    expect_refused([&] { load_at(folder, played, {node}, 1); }, parts);
  };
  const std::string moves = of_node_0 + R"("translation")";
  refused(moves, {0, 1}, {0, 0, 0}, 3, "", {"animation 'walk', the translation of node 0", "2 keys", "3 numbers"});
  refused(moves, {0, 1}, {0, 0, 0, 1, 1, 1}, 3, "CUBICSPLINE", {"each key needs 9"});
  refused(moves, {0, 0}, {0, 0, 0, 1, 1, 1}, 3, "", {"time of key 1 is not after"});
  refused(moves, {0, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, 4, "", {"output", "4 components where 3 are needed"});
  refused(moves, {0, 1}, {0, 0, 0, 1, 1, 1}, 3, "BEZIER", {"channel 0", "none of LINEAR, STEP, CUBICSPLINE"});
  refused(R"("node":7,"path":"scale")", {0}, {1, 1, 1}, 3, "", {"node 7", "1 nodes"});
  refused(moves, {0}, {1, 1, 1}, 3, "", {"placed by a matrix"}, R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})");
  refused(moves, {0}, {NAN, 1, 1}, 3, "", {"not finite"});
}

}  // namespace
}  // namespace lamina
