// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/run_timer.h"

#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"

namespace lamina {

RunTimer::RunTimer(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache, double& spent_s,
                   WhenKnown when_known)
    : certificate_(backend, shaders, cache, [] { return StopSignals::stopped_by() != 0; }),
      spent_s_(spent_s),
      when_known_(std::move(when_known)) {
  measure_alone(certificate_alone_s);
  if (!certificate_.is_open()) tell();
}

std::function<void()> RunTimer::beside() {
  if (is_known_) return {};
  return [this] {
    const Stopwatch watch;
    certificate_.run_round();
    spent_s_ += watch.elapsed_s();
  };
}

bool RunTimer::settle() {
  if (!is_known_) measure_alone(max_certificate_s), tell();
  return certificate_.row().ok;
}

void RunTimer::measure_alone(double until_spent_s) {
  const Stopwatch watch;
  certificate_.measure_alone(until_spent_s);
  spent_s_ += watch.elapsed_s();
}

void RunTimer::tell() {
  when_known_(certificate_.row());
  is_known_ = true;
}

}  // namespace lamina
