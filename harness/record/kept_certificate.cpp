// SPDX-License-Identifier: Apache-2.0
#include "harness/record/kept_certificate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "harness/core/disk_cache.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"
#include "harness/measure/timer_work.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

constexpr double max_age_s = 24 * 3600;

double now_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

// All that a certificate depends on. A home folder may be shared by several machines.
std::string cache_key(const DeviceInfo& info, const std::filesystem::path& shaders) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const char* threads = std::getenv("LP_NUM_THREADS");
  return "timer_" +
         hash_hex(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", info.backend, info.device, info.driver, info.api_version,
                              host.data(), threads ? threads : "", read_file(shaders / "measure/work.frag", "timer")));
}

}  // namespace

CertificateCache::CertificateCache(const DeviceInfo& device, const std::filesystem::path& shaders, std::filesystem::path cache)
    : cache_(std::move(cache)), key_(cache_key(device, shaders)) {}

std::optional<TimerRow> CertificateCache::find() const {
  DiskCache kept(cache_);
  const std::optional<std::string> bytes = kept.find(key_);
  if (!bytes) return std::nullopt;
  try {
    const nlohmann::json there = nlohmann::json::parse(*bytes);
    TimerRow row = row_of<TimerRow>(there.at("timer"), kept.file_of(key_).string());
    row.age_s = now_s() - there.at("measured_at_s").get<double>();
    if (row.ok && *row.age_s >= 0 && *row.age_s < max_age_s) return row;
  } catch (const std::exception&) {
    // of another release: measured again
  }
  return std::nullopt;
}

void CertificateCache::keep(const TimerRow& row) const {
  DiskCache kept(cache_);
  if (row.ok) kept.keep(key_, nlohmann::ordered_json{{"measured_at_s", now_s()}, {"timer", to_json(row)}}.dump());
}

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
  kept_.keep(row_);
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
