// SPDX-License-Identifier: Apache-2.0
#include "harness/record/pending_certificate.h"

#include "harness/measure/timer_work.h"

namespace lamina {

PendingCertificate::PendingCertificate(Backend& backend, const std::filesystem::path& shaders,
                                       const std::filesystem::path& cache, std::function<bool()> stop, TimerRounds so_far)
    : backend_(backend.info().backend), kept_(backend.info(), shaders, cache), stop_(std::move(stop)) {
  if (const std::optional<TimerRow> row = kept_.find()) {
    row_ = *row;
    return;
  }
  certificate_ = std::make_unique<TimerCertificate>(timer_work(backend, shaders), std::move(so_far));
  take_row();
}

void PendingCertificate::take_row() {
  row_ = certificate_->row();
  row_.backend = backend_;
  if (row_.ok) kept_.keep(row_);
}

void PendingCertificate::run_round() {
  if (!is_open()) return;
  const Stopwatch watch;
  certificate_->run_round();
  spent_s_ += watch.elapsed_s();
  take_row();
}

const TimerRow& PendingCertificate::measure_alone(double until_spent_s) {
  while (is_open() && spent_s_ < until_spent_s && !(stop_ && stop_())) run_round();
  return row_;
}

TimerRow certified_timer(Backend& backend, const std::filesystem::path& shaders, const std::filesystem::path& cache,
                         double max_s) {
  return PendingCertificate(backend, shaders, cache).measure_alone(max_s);
}

}  // namespace lamina
