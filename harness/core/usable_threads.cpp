// SPDX-License-Identifier: Apache-2.0
#include "harness/core/usable_threads.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace lamina {
namespace {

namespace fs = std::filesystem;

size_t rounded_up(double quota_us, double period_us) {
  if (!(quota_us > 0 && period_us > 0)) return 0;
  constexpr double max = 1 << 20;
  return static_cast<size_t>(std::clamp(std::max(1.0, quota_us / period_us), 1.0, max) + 0.999);
}

// Of two limits where 0 is none.
size_t min_limit(size_t a, size_t b) { return a == 0 ? b : b == 0 ? a : std::min(a, b); }

double number_in_file(const fs::path& file) {
  double value = 0;
  std::ifstream(file) >> value;
  return value;
}

// "max 100000" is no limit, "150000 100000" one and a half processors.
size_t limit_of_version_2(const fs::path& file) {
  std::string quota;
  double period_us = 0;
  std::ifstream(file) >> quota >> period_us;
  std::istringstream words(quota);
  double quota_us = 0;
  return words >> quota_us ? rounded_up(quota_us, period_us) : 0;
}

}  // namespace

size_t threads_of_quota(const fs::path& root) {
  size_t limit = 0;
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // "NUMBER:CONTROLLERS:/PATH"; version 2 has no controllers
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path path = fs::path(line.substr(second + 1)).relative_path();
    const fs::path mounted = root / "sys/fs/cgroup";
    if (controllers == ",,") {
      limit = min_limit(limit, limit_of_version_2(mounted / "cpu.max"));  // a container's own root
      fs::path group = mounted;
      for (const fs::path& part : path) limit = min_limit(limit, limit_of_version_2((group /= part) / "cpu.max"));
    } else if (controllers.find(",cpu,") != std::string::npos) {
      for (const fs::path& group : {mounted / "cpu" / path, mounted / "cpu"})
        limit = min_limit(limit,
                          rounded_up(number_in_file(group / "cpu.cfs_quota_us"), number_in_file(group / "cpu.cfs_period_us")));
    }
  }
  return limit;
}

size_t usable_threads() {
  const size_t processors = std::max<size_t>(std::thread::hardware_concurrency(), 1);  // of the affinity mask, in glibc
  return min_limit(processors, threads_of_quota("/"));
}

}  // namespace lamina
