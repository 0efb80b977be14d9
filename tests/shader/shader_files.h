// SPDX-License-Identifier: Apache-2.0
// Shader files written for one test, in a folder of their own that goes when the test ends.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "harness/shader/shader.h"
#include "tests/folder.h"

namespace lamina {

inline constexpr Api both_apis[] = {Api::vulkan, Api::opengl};

class ShaderFiles : public InFolder<> {
 protected:
  std::filesystem::path folder() const { return folder_; }

  // `body` is the source after its #version line.
  CompiledShader compile(Stage stage, Api api, std::string_view body, std::map<std::string, std::string> defines = {}) const {
    const char* names[] = {"test.vert", "test.frag", "test.comp"};
    const auto file = write(names[static_cast<int>(stage)], "#version 450\n" + std::string(body));
    return compile_shader({.file = file, .stage = stage, .api = api, .defines = std::move(defines), .include_dirs = {}});
  }
};

// The error that `action` throws; a test failure where it throws none.
template <class Action>
Error error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {ErrorKind::failed, "", "", ""};
}

}  // namespace lamina
