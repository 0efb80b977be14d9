// SPDX-License-Identifier: Apache-2.0
// Compiled shaders by file, stage, API and definitions: each is compiled once.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "harness/shader/shader.h"

namespace lamina {

class ShaderCache {
 public:
  ShaderCache(Api api, std::filesystem::path shaders) : api_(api), shaders_(std::move(shaders)) {}
  std::shared_ptr<const CompiledShader> get(const std::filesystem::path& file, Stage stage,
                                            const std::map<std::string, std::string>& defines);
  // The same shader with another binding for one resource, made once.
  std::shared_ptr<const CompiledShader> rebound(const std::shared_ptr<const CompiledShader>& shader, uint32_t from,
                                                uint32_t to);
  Api api() const { return api_; }
  // Every shader is changed so before it is used: how a fault is put into code. Before the first get().
  using Change = std::function<void(const std::filesystem::path& file, CompiledShader& shader)>;
  void set_change(Change change) { change_ = std::move(change); }

 private:
  Api api_;
  std::filesystem::path shaders_;
  Change change_;
  std::map<std::string, std::shared_ptr<const CompiledShader>> compiled_;
  std::map<std::tuple<const CompiledShader*, uint32_t, uint32_t>, std::shared_ptr<const CompiledShader>> rebound_;
};

}  // namespace lamina
