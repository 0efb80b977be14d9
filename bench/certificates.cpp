// SPDX-License-Identifier: Apache-2.0
// How often a timer's certificate holds while other programs keep cores busy: bench_certificates BACKEND CERTIFICATES
// BUSY_LOOPS. Each certificate is measured by itself, from its first round on, and none is kept. A line each, then how many
// held.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/core/steady_heap.h"
#include "harness/record/kept_certificate.h"

namespace lamina {
namespace {

// Ends with this.
class BusyLoops {
 public:
  explicit BusyLoops(int count) {
    for (int i = 0; i < count; ++i) {
      const pid_t id = ::fork();
      if (id == 0)
        for (;;)
          if (::getppid() == 1) ::_exit(0);  // whoever started it is gone
      loops_.push_back(id);
    }
  }
  ~BusyLoops() {
    for (const pid_t id : loops_) ::kill(id, SIGTERM);
  }
  BusyLoops(const BusyLoops&) = delete;
  BusyLoops& operator=(const BusyLoops&) = delete;

 private:
  std::vector<pid_t> loops_;
};

int run(const std::string& name, int count, int loops) {
  ::setenv("LP_NUM_THREADS", std::to_string(std::thread::hardware_concurrency()).c_str(), 0);
  const BusyLoops busy(loops);
  const std::unique_ptr<Backend> backend = open_backend(name, {});
  int held = 0;
  for (int i = 0; i < count; ++i) {
    PendingCertificate certificate(*backend, LAMINA_SOURCE_DIR "/shaders", "");
    const TimerRow& row = certificate.measure_alone(max_certificate_s);
    held += row.ok;
    fmt::print(
        "{:>3} {} after {:.1f} s, {} rounds of passes of {:.0f} ms: {:.3f} of linear, fixed {:.3f}, sum over wall {:.3f} {}\n",
        i + 1, row.ok ? "holds" : "FAILS", certificate.spent_s(), certificate.rounds().times_ms.size(), row.one_ms.value_or(0),
        fmt::join(row.linearity, ", "), row.fixed_share.value_or(0), row.additivity.value_or(0), row.reason);
    std::fflush(stdout);
  }
  fmt::print("{} of {} certificates on {} held beside {} busy loops\n", held, count, name, loops);
  return held == count ? 0 : 1;
}

}  // namespace
}  // namespace lamina

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "usage: bench_certificates BACKEND CERTIFICATES BUSY_LOOPS\n");
    return 2;
  }
  lamina::use_steady_heap();
  return lamina::run(arguments[1], std::atoi(arguments[2]), std::atoi(arguments[3]));
}
