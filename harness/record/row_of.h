// SPDX-License-Identifier: Apache-2.0
// Lines of the record back to rows.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lamina {

// The row that the line holds, for every row of this folder; fields that it does not know are passed over. Throws
// Error(bad_input, "record", where, ...) for a field that is missing, or not what the row may hold.
template <class Row>
Row row_of(const nlohmann::json& line, const std::string& where);

// The JSON Schema of the row's line: what row_of() takes, but for what check() holds against each other.
template <class Row>
nlohmann::ordered_json schema_of();

}  // namespace lamina
