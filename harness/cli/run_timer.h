// SPDX-License-Identifier: Apache-2.0
// The certificate of a backend's timer in a run that times many cells: measured by itself at first. What stays open goes on
// between the rounds of what is timed first, and is settled after them, before rows with times are written.
#pragma once

#include <filesystem>
#include <functional>

#include "harness/record/kept_certificate.h"

namespace lamina {

class RunTimer {
 public:
  using WhenKnown = std::function<void(const TimerRow&)>;

  // `when_known` is called once. What is spent on the certificate, s by the host's clock, is added to `spent_s`. The backend
  // and `spent_s` must outlive this.
  RunTimer(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache, double& spent_s,
           WhenKnown when_known);

  bool may_be_good() const { return !is_known_ || certificate_.row().ok; }
  // For RoundOptions::beside; empty where the certificate is known.
  std::function<void()> beside();
  // Measures what is left of it. Returns whether times count.
  bool settle();

 private:
  void measure_alone(double until_spent_s);
  void tell();

  PendingCertificate certificate_;
  double& spent_s_;
  const WhenKnown when_known_;
  bool is_known_ = false;
};

}  // namespace lamina
