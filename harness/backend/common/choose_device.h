// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "harness/backend/backend.h"

namespace lamina {

// The place of the device that is meant by `wanted`: its place written as a number, or part of its name in any case; empty: the
// first on the CPU, whose pictures do not depend on the machine, or the first where there is none. Throws Error(bad_input,
// backend, ...) where several devices have the part in their names, and Error(no_device, backend, ...) where none has; both
// list them. `devices` are not empty.
size_t choose_device(std::string_view backend, std::span<const DeviceInfo> devices, std::string_view wanted);

}  // namespace lamina
