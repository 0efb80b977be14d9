// SPDX-License-Identifier: Apache-2.0
// A timer's certificate, measured once a machine, device and day.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// `cache`: a folder; empty: nothing is kept. `shaders`: the folder of the built-in shaders.
class CertificateCache {
 public:
  CertificateCache(const DeviceInfo& device, const std::filesystem::path& shaders, std::filesystem::path cache);

  // The one that was kept within a day on this machine for this device, driver and number of threads: its age_s says so.
  std::optional<TimerRow> find() const;
  // Where it holds: one that failed is never kept.
  void keep(const TimerRow& row) const;

 private:
  std::filesystem::path cache_;
  std::string key_;
};

// The one that is kept, else `measure`'s, which is then kept.
TimerRow certified_timer(const DeviceInfo& device, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                         const std::function<TimerRow()>& measure);

}  // namespace lamina
