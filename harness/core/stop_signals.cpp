// SPDX-License-Identifier: Apache-2.0
#include "harness/core/stop_signals.h"

#include <unistd.h>

#include <csignal>
#include <cstring>
#include <initializer_list>

namespace lamina {
namespace {

volatile std::sig_atomic_t asked_by = 0;
const char* words_on_stop = "";

void ask_to_stop(int signal) {
  asked_by = signal;
  std::signal(signal, SIG_DFL);
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words_on_stop, std::strlen(words_on_stop));
}

}  // namespace

StopSignals::StopSignals(const char* said) {
  words_on_stop = said;
  asked_by = 0;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, ask_to_stop);
  std::signal(SIGXFSZ, SIG_IGN);
}

StopSignals::~StopSignals() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

int StopSignals::stopped_by() { return asked_by; }

void StopSignals::be_silent() { words_on_stop = ""; }

}  // namespace lamina
