// SPDX-License-Identifier: Apache-2.0
// The line of the record that holds a frame, in which only what the scene calls for runs, against the one in which everything
// runs that can; one a backend and view.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/statistics.h"

namespace lamina {

struct SavingRow {
  // Of an effect in one of the two frames.
  struct Cost {
    std::vector<double> ms;                // of its passes, one sample a round
    uint64_t fetches = 0, operations = 0;  // of a frame
    uint64_t once_operations = 0;          // of what is done once
    uint64_t target_bytes = 0;             // of its targets and storage buffers; shared ones count with the first to write them
  };
  struct Effect {
    std::string effect;
    bool called_for = false;
    std::string reason;  // for that
    std::string cannot;  // why it has no part in the frame of everything; "": it has one
    Cost culled, all;
  };
  std::string scene, backend, device, view;
  int width = 0, height = 0;
  std::vector<Effect> effects;
  std::optional<Interval> ratio;  // of the frames' times, culled over all; absent where they are not timed
  uint64_t culled_texture_bytes = 0, all_texture_bytes = 0;  // of the textures that were put on the device
  uint64_t culled_frame_bytes = 0, all_frame_bytes = 0;      // of the frame's picture and depth
  // Of the device's memory, what the frames' targets and storage buffers take where targets share it; absent in records of
  // before.
  std::optional<uint64_t> culled_memory_bytes, all_memory_bytes;
  uint64_t different_pixels = 0;  // whose colours are not the same bits
  double largest_difference = 0;  // of a channel, linear; beyond all bounds where one is not finite: 1e30
  std::string where;              // of it: "pixel 12, 7 of 160x120, by an effect"; "" where the pictures are the same
  std::string failure;            // why there are no figures
};

// One line of the record. Throws Error(failed) for a number that is not finite.
nlohmann::ordered_json to_json(const SavingRow& row);

// The frame's time of each round, ms: the sum over its effects. Empty where nothing was timed.
std::vector<double> saving_frame_ms(const std::vector<SavingRow::Effect>& effects, SavingRow::Cost SavingRow::Effect::*side);

}  // namespace lamina
