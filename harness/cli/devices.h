// SPDX-License-Identifier: Apache-2.0
// The devices that a command runs on: how they are found, and how software ones are held to a number of threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/cli/options.h"

namespace lamina {

// A backend that was asked for, as it is here.
struct ProbedBackend {
  std::string name;
  std::optional<DeviceInfo> device;
  std::string failure;  // why there is no device
};

// Asks each in a process of its own: two OpenGL contexts do not live side by side, processes of a gate must begin without any
// driver loaded, and a driver that crashes takes nothing with it. Call it while this process has no threads. Throws
// Error(bad_input) for a name that is none.
std::vector<ProbedBackend> probe_backends(const DeviceOptions& options);
std::vector<DeviceInfo> devices_of(const std::vector<ProbedBackend>& backends);
// Backends that all opened.
std::vector<ProbedBackend> all_ran(const std::vector<DeviceInfo>& devices);
// Says on standard error which do not open. Throws Error(no_device) where none does. `stage` is the command.
void require_any(std::string_view stage, const std::vector<ProbedBackend>& backends);
// Throws Error(bad_input) where the frame is larger than one of the devices can draw.
void check_size(std::string_view stage, const CellOptions& options, const std::vector<DeviceInfo>& devices);

// As many threads as there are cores, up to what software rasterizers take.
uint32_t thread_for_each_core();
// Pins the number of rasterizer threads where the caller has not, so that the record can say what ran: left alone, software
// rasterizers use one for each core of the affinity mask, whatever else limits them. 0: the caller's thread only. To be called
// before any backend opens.
void pin_rasterizer_threads(uint32_t threads = thread_for_each_core());

}  // namespace lamina
