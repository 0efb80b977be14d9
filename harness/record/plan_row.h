// SPDX-License-Identifier: Apache-2.0
// The line of the record that says what the scene calls for and why, and the passes of every variant, those left out too.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lamina {

struct PlanRow {
  struct Pass {
    std::string pass, effect;
    bool runs = true, once = false;
    std::string reason;  // why it runs, or does not
    std::vector<std::string> objects, reads, writes;
  };
  struct Variant {
    std::string variant;
    bool baseline = false;
    std::vector<Pass> passes;
    std::string error;  // why there are none
  };
  struct Feature {
    std::string feature;
    bool on = false;
    std::string reason;
  };
  struct Effect {
    std::string effect;
    bool called_for = false;
    std::string reason;
    size_t objects = 0;
    std::vector<Feature> features;
    std::vector<Variant> variants;  // none of an effect that is not called for
  };
  std::vector<Effect> effects;
};

nlohmann::ordered_json to_json(const PlanRow& row);

}  // namespace lamina
