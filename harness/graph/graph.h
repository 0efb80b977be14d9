// SPDX-License-Identifier: Apache-2.0
// The passes of one configuration, resolved: shaders compiled with the definitions that each object calls for, every texture
// they can reach traced to its source, and what nobody reads left out. No device is needed; frame.h makes a frame of it.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "harness/plan/plan.h"
#include "harness/shader/shader.h"

namespace lamina {

// Compiled shaders by file, stage, API and definitions: each is compiled once.
class ShaderCache {
 public:
  ShaderCache(Api api, std::filesystem::path shaders) : api_(api), shaders_(std::move(shaders)) {}
  std::shared_ptr<const CompiledShader> get(const std::filesystem::path& file, Stage stage,
                                            const std::map<std::string, std::string>& defines);
  Api api() const { return api_; }

 private:
  Api api_;
  std::filesystem::path shaders_;
  std::map<std::string, std::shared_ptr<const CompiledShader>> compiled_;
};

// Where a texture that a shader reads comes from.
struct Source {
  enum class Kind : uint8_t { object_texture, aperture_map, cap_table, target, frame, depth } kind = Kind::object_texture;
  std::string name;                          // of the object's texture or of the target
  uint32_t aperture = 0;                     // aperture_map: which
  const VariantManifest* variant = nullptr;  // whose target it is
  Sampler sampler;
};
struct ResolvedRead {
  uint32_t binding = 0;
  std::string sampler;  // its name in the shader
  Source source;
};

struct GraphDraw {
  std::optional<size_t> object;  // none: a full-screen or compute pass of the frame
  std::vector<std::shared_ptr<const CompiledShader>> stages;
  std::vector<ResolvedRead> reads;
};

struct GraphPass {
  const VariantManifest* variant = nullptr;
  const PassManifest* pass = nullptr;
  bool once = false;
  std::string reason;            // why it is run, and how often
  std::vector<GraphDraw> draws;  // one an object where the pass is of objects; none for a pass that is left out
};

struct Graph {
  std::vector<GraphPass> passes;   // in order of execution, those that run
  std::vector<GraphPass> dropped;  // those that do not, with the reason
  // Targets and buffers that passes use: (variant, name); an object-scoped one is made for each object that uses it.
  std::set<std::string> shader_hashes() const;
};

// What the passes are for.
enum class Purpose : uint8_t {
  frame,  // pictures and times
  truth,  // a variant that has passes for the truth runs those in place of its others
};

// Throws Error(bad_input) for a shader that does not compile or reads what there is not, Error(failed) for an object that
// cannot be drawn as a pass needs it (unwrapped without a unique unwrap).
Graph make_graph(const Plan& plan, const Configuration& configuration, const Scene& scene, ShaderCache& shaders,
                 Purpose purpose = Purpose::frame);

// Whether the variant tells a truth what each pixel shows.
bool has_truth_passes(const VariantManifest& variant);

// The object's texture of that name, or null. Names: outer_albedo, outer_normal, inner_albedo, albedo.
std::shared_ptr<const TextureImage> object_texture(const Object& object, std::string_view name);

}  // namespace lamina
