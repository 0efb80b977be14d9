// SPDX-License-Identifier: Apache-2.0
// The gate's lines as one JSON object.
#include "reports/gate/gate.h"

namespace lamina {

std::string gate_json(const Record& record) {
  using Json = nlohmann::ordered_json;
  const Json whole = {{"gate", record.gates.empty() ? Json(nullptr) : Json(record.gates.back())},
                      {"aas", Json(record.aas)},
                      {"verdicts", Json(record.verdicts)}};
  return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lamina
