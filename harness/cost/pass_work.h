// SPDX-License-Identifier: Apache-2.0
// What a pass does, as amounts of kinds of work that each have a price on a device.
//
// A kind is wide enough to be met in several variants: formats and filters have prices of their own that add up, and classes of
// operations that cost alike are one kind. Fragments count as the device issues them, in whole blocks, where it tells how many:
// a shader of small triangles pays for the block. Vertex shaders have prices of their own, since few devices run them as they
// run fragments.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "harness/record/cell_rows.h"

namespace lamina {

enum class CountedWork : uint8_t { executed, issued };

// Amounts by kind: "run", "fragment", "vertex", "plain operation", "fetch, trilinear", "fetch, rgba8_unorm", ...
using PassWork = std::map<std::string, double>;
PassWork work_of(const PassRow& pass, CountedWork counted);

}  // namespace lamina
