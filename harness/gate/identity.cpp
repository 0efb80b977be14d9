// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/identity.h"

#include <algorithm>

#include "harness/core/bytes.h"
#include "harness/core/text.h"
#include "harness/core/toml_table.h"
#include "harness/shader/executable_form.h"

namespace lamina {

const std::string& CodeHashes::of(const CompiledShader& shader, Api api) {
  std::string& hash = known_[fmt::format("{} {}", static_cast<int>(api), hash_hex(bytes_of(shader.spirv)))];
  if (hash.empty()) hash = hash_hex(bytes_of(executable_form(shader.spirv, api)));
  return hash;
}

Identity identity_of(const VariantManifest& variant, const Graph& graph, const Graph* truth, Api api, CodeHashes& hashes) {
  const auto code_of = [&](const GraphPass& pass) {
    std::string code;
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages)
        code += fmt::format("\n{} {} {}", pass.pass->name, static_cast<int>(stage->stage), hashes.of(*stage, api));
    return code;
  };
  std::string whole = TomlTable::parse(variant.file, "gate").content();
  const std::filesystem::path effect = variant.file.parent_path() / "effect.toml";
  if (std::filesystem::exists(effect)) whole += TomlTable::parse(effect, "gate").content();
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
