// SPDX-License-Identifier: Apache-2.0
// The record's first line: what was run, and on what. Commands add their settings to it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// Of the run line; a reader refuses any other. It is the first number of the program's version: see CHANGELOG.md.
inline constexpr int record_schema = 1;

// A backend that was asked for, and whether it ran.
struct BackendRow {
  std::string asked;  // "vulkan"
  bool ran = false;
  std::string device, reason;  // which device ran; why none did
};

struct RunRow {
  struct Machine {
    std::string cpu;
    uint32_t threads = 0;
    std::string lp_num_threads;  // of Mesa's rasterizers on the CPU, as the environment says
  };
  int schema = record_schema;
  std::string lamina, commit;              // version and commit of the program
  std::optional<std::string> commit_date;  // UTC
  std::string date, build, command;        // UTC; "release"; as it was typed
  Machine machine;
  std::vector<BackendRow> backends;  // records of before 1.0.0 lack them
  std::vector<DeviceInfo> devices;
};

nlohmann::ordered_json to_json(const RunRow& row);
nlohmann::ordered_json to_json(const DeviceInfo& device);

}  // namespace lamina
