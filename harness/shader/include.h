// SPDX-License-Identifier: Apache-2.0
// #include for glslang: "path" is looked up beside the including file and then, as <path> is, in the include folders.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace lamina {

// Keeps the text of every file that it gave out, so it must outlive the parse. Messages name an included file by the folder it
// was found in, joined with the path as it was written.
class FileIncluder : public glslang::TShader::Includer {
 public:
  explicit FileIncluder(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  // What glslang asks for "path", and where that gives nullptr and for <path>.
  IncludeResult* includeLocal(const char* header, const char* includer, size_t depth) override;
  IncludeResult* includeSystem(const char* header, const char* includer, size_t depth) override;
  void releaseInclude(IncludeResult*) override {}

 private:
  struct Included {
    std::string text;
    IncludeResult result;
    Included(const std::string& name, std::string content)
        : text(std::move(content)), result(name, text.data(), text.size(), nullptr) {}
  };
  // glslang takes a result without a name for a failure, and its text for the reason.
  IncludeResult* give(const std::string& name, std::string text) {
    return &included_.emplace_back(name, std::move(text)).result;
  }
  // The file's result, or nullptr where there is no such file.
  IncludeResult* open(const std::filesystem::path& path);

  std::vector<std::filesystem::path> folders_;
  std::deque<Included> included_;  // a deque: what it holds never moves
};

}  // namespace lamina
