// SPDX-License-Identifier: Apache-2.0
// Rows as a record gives them back.
#pragma once

#include <vector>

#include "harness/record/record.h"

namespace lamina {

template <class Row>
Row read_back(const Row& row) {
  return row_of<Row>(nlohmann::json::parse(to_json(row).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)),
                     "example");
}
template <class Row>
std::vector<Row> read_back(const std::vector<Row>& rows) {
  std::vector<Row> all;
  for (const Row& row : rows) all.push_back(read_back(row));
  return all;
}

}  // namespace lamina
