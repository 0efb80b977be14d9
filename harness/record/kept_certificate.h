// SPDX-License-Identifier: Apache-2.0
// A timer's certificate, measured once a machine, device and day.
#pragma once

#include <filesystem>
#include <functional>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// The certificate that was kept within a day on this machine for this device, driver and number of threads: its age_s says so.
// Else `measure`'s, which is kept where it holds: one that failed is never kept. `cache`: a folder; empty: nothing is kept.
// `shaders`: the folder of the built-in shaders.
TimerRow certified_timer(const DeviceInfo& device, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                         const std::function<TimerRow()>& measure);
// Measured by certify_timer() within `max_s` seconds or a little more.
TimerRow certified_timer(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                         double max_s = 90);

}  // namespace lamina
