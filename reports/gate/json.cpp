// SPDX-License-Identifier: Apache-2.0
// The gate's lines as one JSON object.
#include "reports/gate/gate.h"

namespace lamina {

std::string gate_json(const Record& record) {
  using Json = nlohmann::ordered_json;
  const auto line = [](const auto& row) { return Json(nlohmann::json(to_json(row))); };  // fields in the order of their names
  Json whole = {{"gate", nullptr}, {"aas", Json::array()}, {"verdicts", Json::array()}};
  if (!record.gates.empty()) whole["gate"] = line(record.gates.back());
  for (const SameArmRow& aa : record.aas) whole["aas"].push_back(line(aa));
  for (const VerdictRow& row : record.verdicts) whole["verdicts"].push_back(line(row));
  return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lamina
