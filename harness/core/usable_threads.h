// SPDX-License-Identifier: Apache-2.0
// How many threads are worth starting: containers often see all cores of their host, and may use one.
#pragma once

#include <cstddef>
#include <filesystem>

namespace lamina {

// The processors that `root`'s control groups grant this process, rounded up; 0: they set no limit. Of version 2 (Linux kernel,
// "Control Group v2", section CPU: cpu.max) the least quota on the path from the root group, of version 1 that of the
// process's own group (cpu.cfs_quota_us). `root` has proc/ and sys/, and is / but in tests.
size_t threads_of_quota(const std::filesystem::path& root);

// The lesser of that and the processors of the affinity mask; at least 1.
size_t usable_threads();

}  // namespace lamina
