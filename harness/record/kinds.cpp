// SPDX-License-Identifier: Apache-2.0
#include "harness/record/kinds.h"

#include <cmath>

#include "harness/core/error.h"

namespace lamina::lines {

std::string At::path() const {
  const std::string outer = within ? within->path() : "";
  return outer.empty() ? std::string(name) : fmt::format("{}.{}", outer, name);
}

void refuse(const At& at, std::string message) {
  throw Error(ErrorKind::bad_input, "record", std::string(at.subject), std::move(message));
}

Line finite(double value, const At& at) {
  if (!std::isfinite(value))
    throw Error(ErrorKind::failed, "record", std::string(at.subject),
                fmt::format("{} is not a finite number; record a failure instead", at.path()));
  return value;
}

}  // namespace lamina::lines
