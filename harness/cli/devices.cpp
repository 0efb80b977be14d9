// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "harness/core/usable_threads.h"
#include "harness/gate/child.h"
#include "harness/record/row_of.h"
#include "harness/record/run_row.h"

namespace lamina {
namespace {

// The child's lines: the device, or what is wrong with what was asked for.
ProbedBackend probe(const std::string& name, const DeviceOptions& options) {
  if (std::ranges::find(backend_names(), name) == backend_names().end()) open_backend(name);  // throws: there is none
  const ChildResult child = run_in_child([&](const EmitLine& emit) {
    try {
      emit(to_json(open_backend(name, {options.device, options.validation})->info()));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::bad_input) throw;
      emit({{"refused", error.subject()}, {"message", error.message()}});
    }
  });
  if (!child.failure.empty())  // an error's words begin with the backend, those of a crash do not
    return {name, std::nullopt, child.failure.starts_with(name) ? child.failure : name + ": " + child.failure};
  const nlohmann::json& line = child.lines.front();
  if (line.contains("refused")) throw Error(ErrorKind::bad_input, name, line["refused"], line["message"]);
  return {name, row_of<DeviceInfo>(line, name), ""};
}

}  // namespace

std::vector<ProbedBackend> probe_backends(const DeviceOptions& options) {
  std::vector<ProbedBackend> probed;
  for (const std::string& name : options.backends) probed.push_back(probe(name, options));
  return probed;
}

std::vector<DeviceInfo> devices_of(const std::vector<ProbedBackend>& backends) {
  std::vector<DeviceInfo> devices;
  for (const ProbedBackend& backend : backends)
    if (backend.device) devices.push_back(*backend.device);
  return devices;
}

std::vector<ProbedBackend> all_ran(const std::vector<DeviceInfo>& devices) {
  std::vector<ProbedBackend> backends;
  for (const DeviceInfo& device : devices) backends.push_back({device.backend, device, ""});
  return backends;
}

void require_any(std::string_view stage, const std::vector<ProbedBackend>& backends) {
  for (const ProbedBackend& backend : backends)
    if (!backend.device) fmt::print(stderr, "lamina: {}\n", backend.failure);
  if (std::ranges::any_of(backends, [](const ProbedBackend& backend) { return backend.device.has_value(); })) return;
  throw Error(ErrorKind::no_device, std::string(stage), "no usable device",
              "none of the backends could be opened; see the messages above");
}

void check_size(std::string_view stage, const CellOptions& options, const std::vector<DeviceInfo>& devices) {
  for (const DeviceInfo& device : devices)
    if (std::max(options.width_px, options.height_px) > device.max_texture_size)
      throw Error(ErrorKind::bad_input, std::string(stage), "--size",
                  fmt::format("{}x{} is larger than {} pixels, the most that {} can draw", options.width_px, options.height_px,
                              device.max_texture_size, device.backend));
}

uint32_t thread_for_each_core() { return std::min(static_cast<uint32_t>(usable_threads()), 32u); }

void pin_rasterizer_threads(uint32_t threads) { ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0); }

}  // namespace lamina
