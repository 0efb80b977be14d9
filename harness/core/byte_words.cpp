// SPDX-License-Identifier: Apache-2.0
#include "harness/core/byte_words.h"

#include <fmt/format.h>

namespace lamina {

std::string byte_words(uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} B", bytes);
  double amount = static_cast<double>(bytes);
  size_t prefix = 0;
  constexpr const char* prefixes[] = {"B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  while (amount >= 1024) amount /= 1024, ++prefix;
  return fmt::format("{:.{}f} {}", amount, amount < 10 ? 2 : amount < 100 ? 1 : 0, prefixes[prefix]);
}

}  // namespace lamina
