// SPDX-License-Identifier: Apache-2.0
// The passes of one configuration, resolved: shaders are compiled with the definitions that each object calls for, every
// texture and block member that they name has a source, and passes that nothing reads are left out. No device is needed;
// frame.h makes a frame of it.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "harness/graph/shader_cache.h"
#include "harness/graph/sources.h"
#include "harness/plan/plan.h"

namespace lamina {

struct ResolvedRead {
  uint32_t binding = 0;
  std::string sampler;  // its name in the shader
  Source source;
};
struct ResolvedBuffer {
  uint32_t binding = 0;
  Source source;
};

struct GraphDraw {
  std::optional<size_t> object;                               // none: a full-screen or compute pass of the frame or of a light
  std::optional<size_t> light;                                // that it is drawn for
  std::vector<std::shared_ptr<const CompiledShader>> stages;  // none: nothing is drawn, and targets are cleared alone
  std::vector<ResolvedRead> reads;
  std::vector<ResolvedBuffer> buffers;  // storage
};

struct GraphPass {
  const EffectManifest* effect = nullptr;
  const VariantManifest* variant = nullptr;
  const PassManifest* pass = nullptr;
  bool once = false;
  std::string reason;            // why it is run, and how often
  std::vector<GraphDraw> draws;  // one an object and light where the pass is of them; none for a pass that is left out
};

struct Graph {
  const Library* library = nullptr;
  Parameters parameters;
  std::vector<GraphPass> passes;   // in order of execution, those that run
  std::vector<GraphPass> dropped;  // those that do not, with the reason

  std::set<std::string> shader_hashes() const;
};

// `told`: the variant of the configuration that a truth is told of; its passes for the truth, and those for both, run in place
// of its others, and all other variants draw what they draw in frames. Null: a frame, for pictures and times. Throws
// Error(bad_input) for a shader that does not compile or names something unknown, for a target that is read before anything
// wrote it, for a view of a light where no light casts. Throws Error(failed) for an object that cannot be drawn as a pass needs
// it (unwrapped without a unique unwrap), or whose mesh is open where the variant needs closed ones.
Graph make_graph(const Plan& plan, const Configuration& configuration, const Scene& scene, ShaderCache& shaders,
                 const VariantManifest* told = nullptr, const Parameters& parameters = {});

// Whether the variant has passes for the truth.
bool has_truth_passes(const VariantManifest& variant);

// A target or buffer that passes write and read: the frame's (no object, no light), or one object's or light's. Targets of two
// variants with one name are two targets, unless both declare them shared.
struct Resource {
  const VariantManifest* variant = nullptr;  // null: shared
  std::string name;
  std::optional<size_t> object, light;
  auto operator<=>(const Resource&) const = default;
};
Resource target_of(const VariantManifest& variant, const std::string& name, const GraphDraw& draw,
                   std::optional<size_t> light_of_read = std::nullopt);

}  // namespace lamina
