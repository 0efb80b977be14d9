// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/spirv_passes.h"

#include <fmt/format.h>

#include <string>

namespace lamina {

void register_inlining(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateMergeReturnPass())
      .RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
}

spvtools::Optimizer optimizer_for(Api api) {
  return spvtools::Optimizer(api == Api::vulkan ? SPV_ENV_VULKAN_1_0 : SPV_ENV_OPENGL_4_5);
}

std::vector<uint32_t> rewrite(spvtools::Optimizer& optimizer, const std::vector<uint32_t>& words, std::string_view subject) {
  std::string complaint;
  optimizer.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* text) { complaint = text; });
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);  // compile_shader() did
  std::vector<uint32_t> result;
  if (!optimizer.Run(words.data(), words.size(), &result, options))
    throw Error(ErrorKind::failed, "shader", std::string(subject), "SPIRV-Tools cannot inline the functions: " + complaint);
  return result;
}

}  // namespace lamina
