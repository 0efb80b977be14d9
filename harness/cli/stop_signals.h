// SPDX-License-Identifier: Apache-2.0
// Ctrl-C, asked for politely: what runs is finished first. A second one ends the program at once.
#pragma once

namespace lamina {

class StopSignals {
 public:
  // While this lives, SIGINT and SIGTERM ask to stop, and `said` goes to standard error; it must outlive this. A file that may
  // grow no more is an error of the write, like a full disk. One at a time.
  explicit StopSignals(const char* said);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  // The signal that asked, or 0.
  static int stopped_by();
};

}  // namespace lamina
