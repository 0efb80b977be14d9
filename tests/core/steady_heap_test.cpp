// SPDX-License-Identifier: Apache-2.0
#include "harness/core/steady_heap.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace lamina {
namespace {

// The kernel's flags of the mapping that holds this address: "hg" where huge pages are asked for.
std::string flags_at(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream text(line);
    uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (text >> std::hex >> begin >> dash >> end && dash == '-')
      here = reinterpret_cast<uintptr_t>(address) >= begin && reinterpret_cast<uintptr_t>(address) < end;
    if (here && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

class SteadyHeap : public testing::Test {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer has an allocator of its own";
#endif
    use_steady_heap();
  }
};

// Blocks of the size of a small target, of a large one, and of the largest that the heap takes. A smaller one may lie before the
// first huge page.
TEST_F(SteadyHeap, TargetsLieInHugePages) {
  if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"))
    GTEST_SKIP() << "this kernel has no transparent huge pages";
  for (const size_t megabytes : {4, 16, 31}) {
    const std::vector<std::byte> block(megabytes << 20);
    EXPECT_NE(flags_at(block.data() + block.size() / 2).find(" hg "), std::string::npos) << megabytes << " MiB";
  }
}

// What is freed is used again, so that a second frame's targets lie where the first's were.
TEST_F(SteadyHeap, ABlockIsUsedAgain) {
  const auto place = [] { return reinterpret_cast<uintptr_t>(std::vector<std::byte>(size_t{16} << 20).data()); };
  const uintptr_t first = place();
  EXPECT_EQ(place(), first);
}

}  // namespace
}  // namespace lamina
