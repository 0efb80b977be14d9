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

}  // namespace lamina
