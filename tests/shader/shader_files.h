// SPDX-License-Identifier: Apache-2.0
// Shader files written for one test, in a folder of their own that goes when the test ends.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "harness/shader/shader.h"

namespace lamina {

inline constexpr Api both_apis[] = {Api::vulkan, Api::opengl};

class ShaderFiles : public ::testing::Test {
 protected:
  ShaderFiles() {
    std::string name = "lamina_shader_XXXXXX";
    folder_ = (std::filesystem::temp_directory_path() / name).string();
    if (::mkdtemp(folder_.data()) == nullptr) throw std::runtime_error("no temporary folder");
  }
  ~ShaderFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder() const { return folder_; }
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const {
    const std::filesystem::path path = folder() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path;
  }

  // `body` is the source after its #version line.
  CompiledShader compile(Stage stage, Api api, std::string_view body, std::map<std::string, std::string> defines = {}) const {
    const char* names[] = {"test.vert", "test.frag", "test.comp"};
    const auto file = write(names[static_cast<int>(stage)], "#version 450\n" + std::string(body));
    return compile_shader({.file = file, .stage = stage, .api = api, .defines = std::move(defines), .include_dirs = {}});
  }

 private:
  std::string folder_;
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
