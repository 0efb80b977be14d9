// SPDX-License-Identifier: Apache-2.0
// Control groups as folders of files, as Linux and container engines lay them out.
#include "harness/core/usable_threads.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/folder.h"

namespace lamina {
namespace {

class UsableThreads : public InFolder<> {
 protected:
  size_t quota() const { return threads_of_quota(folder_); }
  size_t quota_with(const std::string& file, const std::string& text) {
    write(file, text);
    return quota();
  }
};

TEST_F(UsableThreads, WithoutGroupsThereIsNoQuota) { EXPECT_EQ(quota(), 0u); }

TEST_F(UsableThreads, AContainerOfOneProcessor) {
  write("proc/self/cgroup", "0::/\n");
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu.max", "100000 100000\n"), 1u);
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu.max", "150000 100000\n"), 2u) << "rounded up";
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu.max", "50000 100000\n"), 1u);
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu.max", "max 100000\n"), 0u);
}

TEST_F(UsableThreads, TheLeastQuotaOnThePathHolds) {
  write("proc/self/cgroup", "0::/user.slice/job.scope\n");
  write("sys/fs/cgroup/user.slice/cpu.max", "300000 100000\n");
  EXPECT_EQ(quota_with("sys/fs/cgroup/user.slice/job.scope/cpu.max", "max 100000\n"), 3u);
  EXPECT_EQ(quota_with("sys/fs/cgroup/user.slice/job.scope/cpu.max", "200000 100000\n"), 2u);
}

TEST_F(UsableThreads, VersionOne) {
  write("proc/self/cgroup", "5:memory:/docker/1\n4:cpu,cpuacct:/docker/1\n");
  write("sys/fs/cgroup/cpu/docker/1/cpu.cfs_quota_us", "400000\n");
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu/docker/1/cpu.cfs_period_us", "100000\n"), 4u);
  EXPECT_EQ(quota_with("sys/fs/cgroup/cpu/docker/1/cpu.cfs_quota_us", "-1\n"), 0u);
}

TEST_F(UsableThreads, AreAtLeastOneAndAtMostTheProcessors) {
  EXPECT_GE(usable_threads(), 1u);
  EXPECT_LE(usable_threads(), std::thread::hardware_concurrency());
}

}  // namespace
}  // namespace lamina
