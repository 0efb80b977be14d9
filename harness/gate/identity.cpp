// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/identity.h"

#include <algorithm>

#include "harness/core/bytes.h"
#include "harness/core/text.h"

namespace lamina {

namespace {

std::string code_of(const GraphPass& pass) {
  std::string code;
  for (const GraphDraw& draw : pass.draws)
    for (const auto& stage : draw.stages)
      code += fmt::format("\n{} {} {}", pass.pass->name, stage->hash, hash_hex(bytes_of(stage->spirv)));
  return code;
}

}  // namespace

Identity identity_of(const VariantManifest& variant, const Graph& graph, const Graph* truth) {
  std::string whole = read_file(variant.file, "gate");
  const std::filesystem::path effect = variant.file.parent_path() / "effect.toml";
  if (std::filesystem::exists(effect)) whole += read_file(effect, "gate");
  Identity identity;
  for (const GraphPass& pass : graph.passes) {
    if (pass.once)
      whole += code_of(pass);
    else
      identity.frame_passes.push_back(hash_hex(code_of(pass)));
  }
  std::string told;
  if (truth)
    for (const GraphPass& pass : truth->passes) told += code_of(pass);
  identity.truth = hash_hex(told);
  identity.whole = hash_hex(whole);
  return identity;
}

size_t same_passes(const Identity& a, const Identity& b) {
  if (a.whole != b.whole) return 0;
  const auto differ = std::ranges::mismatch(a.frame_passes, b.frame_passes);
  return static_cast<size_t>(differ.in1 - a.frame_passes.begin());
}

}  // namespace lamina
