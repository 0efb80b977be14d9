// SPDX-License-Identifier: Apache-2.0
// What scenes made by code take long to make, kept in the cache (disk_cache.h) from one run of a program to the next. An entry
// is of one build of one program, told by the build id that the linker leaves in it: a program built anew makes everything anew
// and writes it over what it finds. Where the program has no build id or no cache, everything is made each time.
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "harness/core/bytes.h"
#include "harness/core/image.h"
#include "harness/core/text.h"
#include "harness/scene/scene.h"

namespace lamina {

using Parts = std::vector<std::string>;  // of something made, as bytes

// What `make` gives. `name` says what that is with all that it depends on beside the code: a file's name.
Parts kept(const std::string& name, const std::function<Parts()>& make);

// Elements as a part, and back. No padding in Value.
template <class Value>
std::vector<Value> values_in(const std::string& part) {
  std::vector<Value> values(part.size() / sizeof(Value));
  std::memcpy(values.data(), part.data(), part.size());
  return values;
}

std::vector<std::shared_ptr<const TextureImage>> kept_textures(
    const std::string& name, const std::function<std::vector<std::shared_ptr<const TextureImage>>()>& make);
Mesh kept_mesh(const std::string& name, const std::function<Mesh()>& make);

}  // namespace lamina
