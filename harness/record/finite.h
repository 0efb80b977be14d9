// SPDX-License-Identifier: Apache-2.0
// Numbers on their way into the record, inside this folder only.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lamina {

// The number, for JSON has neither NaN nor infinity, and the library would write a silent null. Throws Error(failed).
nlohmann::ordered_json finite(double value, const std::string& owner, std::string_view what);

}  // namespace lamina
