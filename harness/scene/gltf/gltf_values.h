// SPDX-License-Identifier: Apache-2.0
// Parts of a glTF file's JSON, checked as they are taken out of it. All throw Error(bad_input) about `subject`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lamina {

// A member that must be a list of objects; null where there is none.
nlohmann::json* list_of(nlohmann::json& root, const char* name, const std::string& subject);

// A member that must be a number of something, from 0 to 2^31 - 1; -1 where there is none.
int index_in(const nlohmann::json& object, const char* name, const std::string& subject);

// A member that must be a whole number from 0 up; `otherwise` where there is none.
uint64_t size_in(const nlohmann::json& object, const char* name, uint64_t otherwise, const std::string& subject);

}  // namespace lamina
