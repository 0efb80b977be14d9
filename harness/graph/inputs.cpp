// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/inputs.h"

#include <algorithm>

#include "harness/core/text.h"
#include "harness/graph/uniforms.h"

namespace lamina {
namespace {

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

class Gathered {
 public:
  explicit Gathered(const Scene& scene) : scene_(scene) {}

  void add(const CompiledShader& shader, std::optional<size_t> object) {
    for (const ShaderResource& resource : shader.reflection.resources) {
      if (resource.name == "Object" && object) add_read(resource, object_uniforms(scene_.objects[*object]));
      if (resource.name == "Frame")  // the size in pixels is the same for all, so any does
        for (const View& view : scene_.views) add_read(resource, frame_uniforms(scene_, view, 1, 1));
    }
  }
  void add(const std::string& more) { text_ += more; }
  std::string hash() const { return hash_hex(text_); }

 private:
  template <class Uniforms>
  void add_read(const ShaderResource& resource, const Uniforms& uniforms) {
    const std::string_view bytes = bytes_of(std::span(&uniforms, 1));
    for (const ByteRange& range : resource.read) text_ += bytes.substr(range.offset, range.size);
  }

  const Scene& scene_;
  std::string text_;
};

// Textures, or buffers other than the scene's apertures.
bool reads_other_passes(const CompiledShader& shader) {
  return std::any_of(shader.reflection.resources.begin(), shader.reflection.resources.end(),
                     [](const ShaderResource& resource) {
                       return resource.kind != BindingKind::uniform_buffer && resource.name != "Apertures";
                     });
}

}  // namespace

std::string meshes_hash(const Scene& scene) {
  std::string text;
  for (const Object& object : scene.objects)
    text += hash_hex(bytes_of(std::span(object.mesh.vertices))) + hash_hex(bytes_of(std::span(object.mesh.indices)));
  return hash_hex(text);
}

std::string once_inputs(const Graph& graph, const Scene& scene) {
  Gathered gathered(scene);
  bool meshes = false;
  for (const GraphPass& pass : graph.passes) {
    if (!pass.once) continue;
    for (const GraphDraw& draw : pass.draws) {
      meshes = meshes || draw.object;
      for (const auto& stage : draw.stages) gathered.add(*stage, draw.object);
    }
  }
  if (meshes) gathered.add(meshes_hash(scene));
  return gathered.hash();
}

std::string coverage_inputs(const Graph& graph, const Scene& scene, bool early_tests) {
  bool everything = !early_tests;
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        everything = everything || (stage->stage == Stage::vertex && reads_other_passes(*stage));
  Gathered gathered(scene);
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        if (everything || stage->stage == Stage::vertex) gathered.add(*stage, draw.object);
  gathered.add(meshes_hash(scene));
  return gathered.hash();
}

}  // namespace lamina
