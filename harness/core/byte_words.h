// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

// "640 B", "48.0 KiB", "1.25 MiB": three digits or more, IEC 80000-13's binary prefixes.
std::string byte_words(uint64_t bytes);

}  // namespace lamina
