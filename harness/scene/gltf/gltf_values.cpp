// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/scene/gltf/gltf_json.h"

namespace lamina {

using Json = nlohmann::json;

Json* list_of(Json& root, const char* name, const std::string& subject) {
  const auto found = root.find(name);
  if (found == root.end()) return nullptr;
  if (!found->is_array() || !std::ranges::all_of(*found, [](const Json& one) { return one.is_object(); }))
    refuse_gltf(subject, fmt::format("'{}' is not a list of objects", name));
  return &*found;
}

int index_in(const Json& object, const char* name, const std::string& subject) {
  const auto found = object.find(name);
  if (found == object.end()) return -1;
  if (!found->is_number_unsigned() || found->get<uint64_t>() > 0x7fffffff)
    refuse_gltf(subject, fmt::format("'{}' is not a number from 0 up", name));
  return found->get<int>();
}

uint64_t size_in(const Json& object, const char* name, uint64_t otherwise, const std::string& subject) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned()) refuse_gltf(subject, fmt::format("'{}' is not a whole number from 0 up", name));
  return found->get<uint64_t>();
}

}  // namespace lamina
