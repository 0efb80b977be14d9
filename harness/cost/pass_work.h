// SPDX-License-Identifier: Apache-2.0
// What a pass does, as amounts of kinds of work that each have a price on a device.
//
// A kind is wide enough to be met in several variants. Decoding and filtering have prices of their own that add up. Operations
// are one kind, each worth about as many additions as it takes; exponentials and trigonometry have a further price. Fragments
// count as the device issues them, in whole blocks, where it tells how many: a shader of small triangles pays for the block.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "harness/record/cell_rows.h"

namespace lamina {

enum class CountedWork : uint8_t { executed, issued };

// Amounts by kind: "run", "fragment", "vertex", "operation", "fetch, trilinear", "fetch, of half floats", ...
using PassWork = std::map<std::string, double>;
PassWork work_of(const PassRow& pass, CountedWork counted);

}  // namespace lamina
