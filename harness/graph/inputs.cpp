// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/inputs.h"

#include <algorithm>

#include "harness/core/bytes.h"
#include "harness/core/text.h"
#include "harness/graph/blocks.h"
#include "harness/scene/digest.h"

namespace lamina {
namespace {

class Gathered {
 public:
  Gathered(const Graph& graph, const Scene& scene) : graph_(graph), scene_(scene) {}

  // Of every uniform block, the members that the shader's code reads.
  void add(const GraphPass& pass, const GraphDraw& draw, const CompiledShader& shader) {
    for (const ShaderResource& resource : shader.reflection.resources) {
      if (resource.kind != BindingKind::uniform_buffer || resource.name == "Pass") continue;
      const size_t views = resource.name == "Frame" ? scene_.views.size() : 1;
      for (size_t view = 0; view < views; ++view) {  // the size in pixels is the same for all, so any does
        const BlockContext context{
            scene_, *graph_.library, *pass.effect, pass.pass->where, view, pass.pass->view, draw.light, draw.object, 1, 1, {}};
        const std::vector<std::byte> bytes = fill_block(resource, block_values(resource, context), pass.pass->where);
        for (const ByteRange& range : resource.read) text_ += bytes_of(bytes).substr(range.offset, range.size);
      }
    }
  }
  void add(const std::string& more) { text_ += more; }
  std::string hash() const { return hash_hex(text_); }

 private:
  const Graph& graph_;
  const Scene& scene_;
  std::string text_;
};

// Targets or buffers that other passes write.
bool reads_other_passes(const GraphDraw& draw, const CompiledShader& shader) {
  return std::any_of(shader.reflection.resources.begin(), shader.reflection.resources.end(),
                     [&](const ShaderResource& resource) {
                       if (resource.kind == BindingKind::texture)
                         return std::any_of(draw.reads.begin(), draw.reads.end(), [&](const ResolvedRead& read) {
                           return read.binding == resource.binding &&
                                  (read.source.kind == Source::Kind::target || read.source.kind == Source::Kind::frame ||
                                   read.source.kind == Source::Kind::depth);
                         });
                       return resource.kind == BindingKind::storage_image ||
                              std::any_of(draw.buffers.begin(), draw.buffers.end(), [&](const ResolvedBuffer& buffer) {
                                return buffer.binding == resource.binding && buffer.source.kind == Source::Kind::buffer;
                              });
                     });
}

}  // namespace

std::string once_inputs(const Graph& graph, const Scene& scene) {
  Gathered gathered(graph, scene);
  bool meshes = false;
  for (const GraphPass& pass : graph.passes) {
    if (!pass.once) continue;
    for (const GraphDraw& draw : pass.draws) {
      meshes = meshes || draw.object;
      for (const auto& stage : draw.stages) gathered.add(pass, draw, *stage);
    }
  }
  if (meshes) gathered.add(meshes_digest(scene));
  return gathered.hash();
}

std::string coverage_inputs(const Graph& graph, const Scene& scene, bool early_tests) {
  bool everything = !early_tests;
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        everything = everything || (stage->stage == Stage::vertex && reads_other_passes(draw, *stage));
  Gathered gathered(graph, scene);
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        if (everything || stage->stage == Stage::vertex) gathered.add(pass, draw, *stage);
  gathered.add(meshes_digest(scene));
  return gathered.hash();
}

}  // namespace lamina
