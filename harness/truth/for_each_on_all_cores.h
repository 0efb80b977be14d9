// SPDX-License-Identifier: Apache-2.0
// The loop of a truth over its points or rows.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <mutex>

namespace lamina {

// Runs work(i) for each i below `count`, on all cores and in no order. Tells `progress`, from 0 to 1, about every hundredth of
// the way and at the end, from one thread at a time.
template <class Work>
void for_each_on_all_cores(size_t count, const std::function<void(double)>& progress, const Work& work) {
  const size_t between = std::max<size_t>(count / 128, 1);
  std::mutex telling;
  size_t done = 0;
  tbb::parallel_for(size_t{0}, count, [&](size_t i) {
    work(i);
    const std::lock_guard lock(telling);
    if (++done % between == 0) progress(static_cast<double>(done) / static_cast<double>(count));
  });
  progress(1);
}

}  // namespace lamina
