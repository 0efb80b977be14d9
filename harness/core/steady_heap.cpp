// SPDX-License-Identifier: Apache-2.0
#include "harness/core/steady_heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace lamina {
namespace {

constexpr int heap_bytes = 1 << 30;
constexpr int max_block_bytes = 32 << 20;  // glibc allows no larger one
constexpr uintptr_t huge_page_bytes = 2 << 20;

uintptr_t heap_end() { return reinterpret_cast<uintptr_t>(::sbrk(0)); }

}  // namespace

void use_steady_heap() {
  const uintptr_t before = heap_end();
  if (::mallopt(M_MMAP_THRESHOLD, max_block_bytes) == 0 || ::mallopt(M_TOP_PAD, heap_bytes) == 0 ||
      ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max()) == 0)
    return;
  void* volatile larger_than_what_is_left = std::malloc(max_block_bytes / 2);
  std::free(larger_than_what_is_left);
  const uintptr_t begin = (before + huge_page_bytes - 1) / huge_page_bytes * huge_page_bytes, end = heap_end();
  if (end > begin) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace lamina
