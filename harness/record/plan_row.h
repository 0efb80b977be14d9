// SPDX-License-Identifier: Apache-2.0
// The line of the record that says what the scene calls for and why, the passes of every variant, those left out too, and the
// frame in which every effect stands at its variant: its passes in order, and its targets.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

struct PlanRow {
  struct Pass {
    std::string pass, effect;
    bool runs = true, once = false;
    std::string reason;  // why it runs, or does not
    std::vector<std::string> objects, reads, writes;
    std::string variant;  // of a frame's pass
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
  // A target or storage buffer of the frame, with those of its name that objects or lights have of their own.
  struct Target {
    std::string target, effect, variant;     // effect and variant: whose it is; "" for one that is shared or the frame's own
    bool shared = false;                     // one for all effects that declare it
    uint64_t copies = 1;                     // one for each object or light that has one
    std::vector<uint64_t> writers, readers;  // passes by their place in the frame; what writes at its end may read it too
    uint64_t bytes = 0;                      // of all copies, as their formats say
  };
  struct Frame {
    uint64_t width = 0, height = 0;  // pixels
    std::vector<Pass> passes;        // those that run: what is done once, then each frame, in order
    std::vector<Pass> left_out;
    std::vector<Target> targets;
    // What targets and storage buffers take together, as their formats say, where targets that are needed at different times
    // lie in one memory, and where they are one texture if they are alike. Absent in records of before.
    std::optional<uint64_t> aliased_bytes{}, reused_bytes{};
  };
  std::vector<Effect> effects;
  std::optional<Frame> frame{};  // absent where it cannot run, and in records of before
  std::string frame_error{};     // why
};

nlohmann::ordered_json to_json(const PlanRow& row);

}  // namespace lamina
