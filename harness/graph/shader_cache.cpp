// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/shader_cache.h"

namespace lamina {

std::shared_ptr<const CompiledShader> ShaderCache::get(const std::filesystem::path& file, Stage stage,
                                                       const std::map<std::string, std::string>& defines) {
  std::string key = fmt::format("{}|{}", file.string(), static_cast<int>(stage));
  for (const auto& [name, text] : defines) key += fmt::format("|{}={}", name, text);
  auto& entry = compiled_[key];
  if (entry) return entry;
  CompiledShader shader = compile_shader({file, stage, api_, defines, {shaders_, file.parent_path()}});
  if (change_) change_(file, shader);
  return entry = std::make_shared<const CompiledShader>(std::move(shader));
}

std::shared_ptr<const CompiledShader> ShaderCache::rebound(const std::shared_ptr<const CompiledShader>& shader, uint32_t from,
                                                           uint32_t to) {
  auto& entry = rebound_[{shader.get(), from, to}];
  if (!entry) entry = std::make_shared<const CompiledShader>(lamina::rebound(*shader, from, to));
  return entry;
}

}  // namespace lamina
