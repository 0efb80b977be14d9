// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"

namespace lamina {

// Told what is being done, and which fraction of it is.
using Tell = std::function<void(double fraction, const std::string& what)>;

// One line on standard error that is written over, with the fraction done and the time left; silent where no person watches.
class Progress {
 public:
  explicit Progress(std::string title);
  ~Progress();
  void show(double fraction, const std::string& what);
  // The same; must not outlive this.
  Tell tell() {
    return [this](double fraction, const std::string& what) { show(fraction, what); };
  }
  // The same, but throws StopRequested once a signal has asked to stop.
  Tell tell_or_stop() {
    return [this](double fraction, const std::string& what) {
      if (StopSignals::stopped_by() != 0) throw StopRequested();
      show(fraction, what);
    };
  }

 private:
  std::string title_;
  bool watched_;
  Stopwatch watch_;
};

}  // namespace lamina
