// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/include.h"

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

constexpr size_t deepest_include = 64;  // deeper than any sensible nesting; a file that includes itself ends here

}  // namespace

FileIncluder::IncludeResult* FileIncluder::open(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return nullptr;
  try {
    return give(path.string(), read_file(path, "shader"));
  } catch (const Error& error) {  // glslang's own code is built without exceptions: none may pass through it
    return give("", error.what());
  }
}

FileIncluder::IncludeResult* FileIncluder::includeLocal(const char* header, const char* includer, size_t depth) {
  if (depth > deepest_include) return nullptr;
  return open((std::filesystem::path(includer).parent_path() / header).lexically_normal());
}

FileIncluder::IncludeResult* FileIncluder::includeSystem(const char* header, const char*, size_t depth) {
  if (depth > deepest_include) return give("", "files include each other in a circle; give them include guards");
  for (const std::filesystem::path& folder : folders_)
    if (IncludeResult* result = open((folder / header).lexically_normal())) return result;
  return give("", "no such file beside the including file or in the include folders");
}

}  // namespace lamina
