// SPDX-License-Identifier: Apache-2.0
// Ctrl-C, asked for politely: what runs is finished first. A second one ends the program at once.
#pragma once

namespace lamina {

// Said by commands whose report holds what was measured until then.
inline constexpr const char* report_on_stop =
    "\nlamina: writing the report of what is measured; a second Ctrl-C stops at once\n";

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
  // In a process that was forked while this lives: it is asked to stop too, and the words are its parent's to say.
  static void be_silent();
};

// Thrown where a wish to stop is heeded in the middle of work; no std::exception, so that it is nobody's failure.
struct StopRequested {};

}  // namespace lamina
