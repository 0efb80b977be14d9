// SPDX-License-Identifier: Apache-2.0
// Numbers on their way into the record, inside this folder only.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "harness/measure/statistics.h"

namespace lamina {

// The number, for JSON has neither NaN nor infinity, and the library would write a silent null. Throws Error(failed).
nlohmann::ordered_json finite(double value, const std::string& owner, std::string_view what);
// Its fields, or null. Throws likewise.
nlohmann::ordered_json interval_to_json(const std::optional<Interval>& interval, const std::string& owner,
                                        std::string_view what);

}  // namespace lamina
