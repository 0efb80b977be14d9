// SPDX-License-Identifier: Apache-2.0
// The host's uniform blocks against what the shaders declare, name by name, on both APIs; and the camera against geometry.
#include "harness/graph/uniforms.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "harness/shader/shader.h"

namespace lamina {
namespace {

using Offsets = std::map<std::string, uint32_t>;

Offsets declared(Api api, Stage stage, const std::string& file, const std::string& block) {
  const std::filesystem::path shaders = std::filesystem::path(LAMINA_SOURCE_DIR) / "shaders";
  Offsets offsets;
  for (const ShaderResource& resource : compile_shader({shaders / file, stage, api, {}, {shaders}}).reflection.resources)
    if (resource.name == block)
      for (const BlockMember& member : resource.members) offsets[member.name] = member.offset_bytes;
  return offsets;
}

TEST(Uniforms, HostLayoutIsTheShaders) {
  for (const Api api : {Api::vulkan, Api::opengl}) {
    EXPECT_EQ(declared(api, Stage::vertex, "common/object.vert", "Frame"),
              (Offsets{{"clip_from_world", offsetof(FrameUniforms, clip_from_world)},
                       {"eye_world", offsetof(FrameUniforms, eye_world)},
                       {"ambient", offsetof(FrameUniforms, ambient)},
                       {"frame_size_px", offsetof(FrameUniforms, frame_size_px)},
                       {"light_count", offsetof(FrameUniforms, light_count)},
                       {"light_position", offsetof(FrameUniforms, light_position)},
                       {"light_radiance", offsetof(FrameUniforms, light_radiance)}}));
    EXPECT_EQ(declared(api, Stage::vertex, "common/object.vert", "Object"),
              (Offsets{{"world_from_object", offsetof(ObjectUniforms, world_from_object)},
                       {"world_from_object_normal", offsetof(ObjectUniforms, world_from_object_normal)},
                       {"layer", offsetof(ObjectUniforms, layer)}}));
    EXPECT_EQ(declared(api, Stage::fragment, "layered_material/jump_flood.frag", "Pass"),
              (Offsets{{"iteration", offsetof(PassUniforms, iteration)}}));
  }
}

TEST(Uniforms, CameraPutsUpOnTopAndNearInFront) {
  Scene scene;
  View view;
  view.eye = {0, 0, 5};
  const glm::mat4 clip_from_world = frame_uniforms(scene, view, 200, 100).clip_from_world;
  const auto place = [&](glm::vec3 world) {
    const glm::vec4 clip = clip_from_world * glm::vec4(world, 1);
    return glm::vec3(clip) / clip.w;
  };
  EXPECT_NEAR(place({0, 0, 0}).x, 0, 1e-6);
  EXPECT_GT(place({1, 0, 0}).x, 0);
  EXPECT_LT(place({0, 1, 0}).y, 0) << "y runs down in clip space";
  EXPECT_LT(place({0, 0, 1}).z, place({0, 0, 0}).z) << "nearer is smaller";
  EXPECT_NEAR(place({0, 0, 5 - view.near_m}).z, 0, 1e-5);
  EXPECT_NEAR(place({0, 0, 5 - view.far_m}).z, 1, 1e-5);
  // Half the field of view lies above the middle; the frame is twice as wide as high.
  const float top = 5 * std::tan(glm::radians(view.fov_y_degrees) / 2);
  EXPECT_NEAR(place({0, top, 0}).y, -1, 1e-5);
  EXPECT_NEAR(place({2 * top, 0, 0}).x, 1, 1e-5);
}

TEST(Uniforms, NormalsAreTransformedByTheInverseTranspose) {
  Object object;
  object.world_from_object = glm::scale(glm::mat4(1), glm::vec3(1, 4, 1));
  const glm::vec3 along{1, -1, 0}, normal{1, 1, 0};  // perpendicular in object space
  const glm::vec3 world_along = glm::vec3(object.world_from_object * glm::vec4(along, 0));
  const glm::vec3 world_normal = glm::mat3(object_uniforms(object).world_from_object_normal) * normal;
  EXPECT_NEAR(glm::dot(world_along, world_normal), 0, 1e-6);
}

TEST(Uniforms, DirectionalLightsPointTowardsTheLight) {
  Scene scene;
  scene.lights.push_back({"sun", Light::Kind::directional, {0, -1, 0}, {}, {1, 2, 3}});
  scene.lights.push_back({"lamp", Light::Kind::point, {}, {4, 5, 6}, {1, 1, 1}});
  const FrameUniforms uniforms = frame_uniforms(scene, {}, 1, 1);
  EXPECT_EQ(uniforms.light_count.x, 2);
  EXPECT_EQ(uniforms.light_position[0], glm::vec4(0, 1, 0, 0));
  EXPECT_EQ(uniforms.light_position[1], glm::vec4(4, 5, 6, 1));
  EXPECT_EQ(uniforms.light_radiance[0], glm::vec4(1, 2, 3, 0));
}

}  // namespace
}  // namespace lamina
