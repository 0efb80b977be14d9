// SPDX-License-Identifier: Apache-2.0
// What a verdict says, in a sentence.
#pragma once

#include <string>

#include "harness/record/gate_rows.h"

namespace lamina {

// Plain text without a full stop, not yet escaped for where it goes: "light_map on vulkan, view front: ssim went from 0.9 to
// 0.8". A row without a cause, of an older record, keeps its own.
std::string sentence_of(const VerdictRow& row);

}  // namespace lamina
