// SPDX-License-Identifier: Apache-2.0
// A timer's certificate, measured once a machine, device and day: first by itself and then, where that did not tell, between a
// run's own rounds.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "harness/backend/backend.h"
#include "harness/measure/timer_certificate.h"
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

// What a certificate may take by itself, s, before the run's own rounds begin, and in all.
inline constexpr double certificate_alone_s = 12, max_certificate_s = 90;

// The certificate of a run's timer: the one that is kept, or one that is measured.
class PendingCertificate {
 public:
  // `cache` and `shaders` as for CertificateCache; `stop` asks whether a signal wants the run to end; `so_far`: rounds of an
  // earlier process, which go on. The backend must outlive this. Throws Error where the passes do not run.
  PendingCertificate(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                     std::function<bool()> stop = {}, TimerRounds so_far = {});

  // Rounds by themselves, until it is known or has taken so long in all. Returns the certificate as it then stands.
  const TimerRow& measure_alone(double until_spent_s);
  // One round, where it is open.
  void run_round();
  bool is_open() const { return certificate_ && certificate_->is_open(); }
  const TimerRow& row() const { return row_; }  // as it stands
  double spent_s() const { return spent_s_; }
  TimerRounds rounds() const { return certificate_ ? certificate_->rounds() : TimerRounds{}; }

 private:
  void take_row();

  const std::string backend_;
  const CertificateCache kept_;
  const std::function<bool()> stop_;
  std::unique_ptr<TimerCertificate> certificate_;  // null: it was kept
  TimerRow row_;
  double spent_s_ = 0;
};

// Measured by itself, where it is not kept, until it is known or has taken so long.
TimerRow certified_timer(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                         double max_s = max_certificate_s);

}  // namespace lamina
