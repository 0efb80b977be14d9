// SPDX-License-Identifier: Apache-2.0
// The certificate's passes on a backend.
#pragma once

#include <filesystem>

#include "harness/measure/timer_certificate.h"

namespace lamina {

// Passes of bilinear fetches, each at a place that depends on the one before; their number is the work. What they need on the
// device is given back at the end; the backend must outlive them. `shaders` is the folder of the built-in shaders. Throws Error
// where they do not compile or the device has no room.
std::unique_ptr<TimedWork> timer_work(Backend& backend, const std::filesystem::path& shaders);

}  // namespace lamina
