// SPDX-License-Identifier: Apache-2.0
// What the driver's own checker says (KHR_debug).
#pragma once

#include <string>
#include <vector>

namespace lamina::gl {

// Keeps messages of medium and high severity, except those on performance: a warning or an error to the user of an API.
// It must stay where it is while its context lives, as the driver holds its address.
class DebugLog {
 public:
  DebugLog() = default;
  DebugLog(const DebugLog&) = delete;
  DebugLog& operator=(const DebugLog&) = delete;

  void listen();  // to the current context, which then reports at the call that is wrong
  std::vector<std::string> take();

 private:
  std::vector<std::string> messages_;
};

}  // namespace lamina::gl
