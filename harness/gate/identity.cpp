// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/identity.h"

#include "harness/core/text.h"

namespace lamina {

std::string identity_of(const VariantManifest& variant, const Graph& graph) {
  std::string whole = read_file(variant.file, "gate");
  const std::filesystem::path effect = variant.file.parent_path() / "effect.toml";
  if (std::filesystem::exists(effect)) whole += read_file(effect, "gate");
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        whole += fmt::format("\n{} {} {}", pass.pass->name, stage->hash,
                             hash_hex({reinterpret_cast<const char*>(stage->spirv.data()), stage->spirv.size() * 4}));
  return hash_hex(whole);
}

}  // namespace lamina
