// SPDX-License-Identifier: Apache-2.0
// What uniform blocks hold, against geometry: read back by name from the bytes that a shader's own block gets.
#include "harness/graph/blocks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/shader/shader.h"
#include "tests/folder.h"

namespace lamina {
namespace {

const Library& library() {
  static const Library loaded = load_library(LAMINA_SOURCE_DIR, effect_code());
  return loaded;
}

// The block of shaders/common/frame.glsl, as a shader with extra members of Frame declares it.
ShaderResource declared(const std::string& block) {
  const std::filesystem::path shaders = std::filesystem::path(LAMINA_SOURCE_DIR) / "shaders";
  const Folder folder;
  const std::filesystem::path file =
      folder.write("blocks.vert",
                   "#define FRAME_MEMBERS ivec4 light_casts[8]; mat4 casting_clip_from_world[8];\n"
                   "#include \"common/frame.glsl\"\n#include \"common/mesh_out.glsl\"\n"
                   "void main() { write_surface(); gl_Position = clip_from_world * vec4(position, 1) + "
                   "casting_clip_from_world[1] * vec4(light_casts[0]); }\n");
  const CompiledShader compiled = compile_shader({file, Stage::vertex, Api::vulkan, {}, {shaders}});
  for (const ShaderResource& resource : compiled.reflection.resources)
    if (resource.name == block) return resource;
  throw std::runtime_error("no such block");
}

// A member's value out of a filled block.
template <class T>
T member(const Scene& scene, const std::string& block, const std::string& name, uint32_t width = 1, uint32_t height = 1,
         size_t element = 0) {
  const ShaderResource resource = declared(block);
  const BlockContext context{scene,  library(), library().effects.front(), "a.toml:1", 0, PassView::eye, {}, 0, width,
                             height, {}};
  const std::vector<std::byte> bytes = fill_block(resource, block_values(resource, context), "a.toml:1");
  for (const BlockMember& candidate : resource.members)
    if (candidate.name == name) {
      T value;
      std::memcpy(&value, bytes.data() + candidate.offset_bytes + element * sizeof(T), sizeof value);
      return value;
    }
  throw std::runtime_error("no such member");
}

Scene scene_with(const View& view) {
  Scene scene;
  scene.objects.emplace_back();
  scene.views = {view};
  return scene;
}

TEST(Uniforms, CameraPutsUpOnTopAndNearInFront) {
  View view;
  view.eye = {0, 0, 5};
  const glm::mat4 clip_from_world = member<glm::mat4>(scene_with(view), "Frame", "clip_from_world", 200, 100);
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
  Scene scene = scene_with({});
  Object& object = scene.objects[0];
  object.world_from_object = glm::scale(glm::mat4(1), glm::vec3(1, 4, 1));
  const glm::vec3 along{1, -1, 0}, normal{1, 1, 0};  // perpendicular in object space
  const glm::vec3 world_along = glm::vec3(object.world_from_object * glm::vec4(along, 0));
  const glm::vec3 world_normal = glm::mat3(member<glm::mat4>(scene, "Object", "world_from_object_normal")) * normal;
  EXPECT_NEAR(glm::dot(world_along, world_normal), 0, 1e-6);
}

TEST(Uniforms, DirectionalLightsPointTowardsTheLight) {
  Scene scene = scene_with({});
  scene.lights.push_back({"sun", Light::Kind::directional, {0, -1, 0}, {}, {1, 2, 3}});
  scene.lights.push_back({"lamp", Light::Kind::point, {}, {4, 5, 6}, {1, 1, 1}});
  EXPECT_EQ(member<glm::ivec4>(scene, "Frame", "light_count"), glm::ivec4(2, 0, 0, 0));
  EXPECT_EQ(member<glm::vec4>(scene, "Frame", "light_position"), glm::vec4(0, 1, 0, 0));
  EXPECT_EQ(member<glm::vec4>(scene, "Frame", "light_position", 1, 1, 1), glm::vec4(4, 5, 6, 1));
  EXPECT_EQ(member<glm::vec4>(scene, "Frame", "light_radiance"), glm::vec4(1, 2, 3, 0));
}

// Of three lights the second and third cast: their views are numbered from 0, and show the scene's middle in theirs.
TEST(Uniforms, LightsThatCastAreNumberedAmongThemselves) {
  Scene scene = scene_with({});
  scene.objects[0].mesh.vertices = {{{-1, 0, 0}, {}, {}, {}}, {{1, 0, 0}, {}, {}, {}}, {{0, 1, 0}, {}, {}, {}}};
  scene.lights.push_back({"fill", Light::Kind::directional, {0, -1, 0}, {}, {1, 1, 1}});
  scene.lights.push_back({"sun", Light::Kind::directional, {0, -1, 0}, {}, {1, 1, 1}, 0, 0, true});
  scene.lights.push_back({"lamp", Light::Kind::point, {}, {0, 5, 6}, {1, 1, 1}, 0, 0, true});
  EXPECT_EQ(member<glm::ivec4>(scene, "Frame", "light_count"), glm::ivec4(3, 2, 0, 0));
  EXPECT_EQ(member<glm::ivec4>(scene, "Frame", "light_casts", 1, 1, 0).x, -1);
  EXPECT_EQ(member<glm::ivec4>(scene, "Frame", "light_casts", 1, 1, 1).x, 0);
  EXPECT_EQ(member<glm::ivec4>(scene, "Frame", "light_casts", 1, 1, 2).x, 1);
  for (size_t light = 0; light < 2; ++light) {
    const glm::vec4 clip = member<glm::mat4>(scene, "Frame", "casting_clip_from_world", 1, 1, light) * glm::vec4(0, 0.5f, 0, 1);
    EXPECT_NEAR(clip.x / clip.w, 0, 0.05) << light;
    EXPECT_NEAR(clip.y / clip.w, 0, 0.05) << light;
  }
}

}  // namespace
}  // namespace lamina
