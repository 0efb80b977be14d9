// SPDX-License-Identifier: Apache-2.0
// A backend for a test, where this machine has a device for it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "harness/backend/backend.h"
#include "harness/core/error.h"

namespace lamina {

// Null where there is no device for it; `missing` then says so, for GTEST_SKIP(). Whatever else goes wrong is thrown.
inline std::unique_ptr<Backend> open_or_say(std::string_view name, std::string& missing, const BackendOptions& options = {}) {
  try {
    return open_backend(name, options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_device) throw;
    missing = error.what();
    return nullptr;
  }
}

}  // namespace lamina
